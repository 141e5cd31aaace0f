package robotran.nqc.support

import robotran.brick.kind.BrickKind
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.ProgramMeasure
import robotran.languagesupport.linesOfBraceCode
import robotran.nqc.edit.NqcSyntax
import robotran.nqc.edit.nqcTokens

object NqcSupport : LanguageSupport {
    override val language = ProgramLanguage.NQC
    override val code: CodeSyntax = NqcSyntax
    override val files: ProgramFiles = NqcFiles
    override val measure: ProgramMeasure = NqcMeasure
    override val bricks = setOf(BrickKind.ofLegoFirmware)
    override val isForLegoFirmware = true

    override fun translations(brick: BrickKind): List<ShownLanguage> = listOf(ShownLanguage.LASM)
}

private object NqcMeasure : ProgramMeasure {
    override fun linesOfCode(text: String): Int = linesOfBraceCode(text)

    override fun normalTokens(text: String): Sequence<String> {
        var isInComment = false
        return text.lineSequence().flatMap { line ->
            val tokens = nqcTokens(line, isInComment).also { isInComment = it.endsInComment }.tokens
            tokens.mapNotNull { token ->
                when (token.kind) {
                    CodeTokenKind.COMMENT -> null
                    CodeTokenKind.NAME -> ProgramMeasure.NAME
                    else -> line.substring(token.start, token.end)
                }
            }
        }
    }
}
