package robotran.robolang.support

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.ProgramMeasure
import robotran.languagesupport.SourceFile
import robotran.robolang.brickOfRobolang
import robotran.robolang.edit.RobolangSyntax
import robotran.robolang.robolangTokens
import robotran.robolang.robolangTokensOfLines

object RobolangSupport : LanguageSupport {
    override val language = ProgramLanguage.ROBOLANG
    override val code: CodeSyntax = RobolangSyntax
    override val files: ProgramFiles = RobolangFiles
    override val measure: ProgramMeasure = RobolangMeasure
    override val hasBlocks = true

    override fun translations(brick: BrickKind): List<ProgramLanguage> = listOfNotNull(
        ProgramLanguage.JAVA.takeIf { brick.java != null },
        ProgramLanguage.NQC.takeIf { brick.hasLegoFirmware },
    )
}

private object RobolangFiles : ProgramFiles(ProgramLanguage.ROBOLANG) {
    override fun brickOf(files: List<SourceFile>): BrickKind? = brickOfRobolang(files.single().text)
}

private object RobolangMeasure : ProgramMeasure {
    override fun linesOfCode(text: String): Int = text.lineSequence().count { line ->
        robolangTokens(line).any { it.kind != CodeTokenKind.COMMENT }
    }

    override fun normalTokens(text: String): Sequence<String> = text.lineSequence().zip(
        robolangTokensOfLines(text).asSequence(),
    ).flatMap { (line, tokens) ->
        tokens.mapNotNull { token ->
            when (token.kind) {
                CodeTokenKind.COMMENT -> null
                CodeTokenKind.NAME -> ProgramMeasure.NAME
                else -> line.substring(token.start, token.end).lowercase()
            }
        }
    }
}
