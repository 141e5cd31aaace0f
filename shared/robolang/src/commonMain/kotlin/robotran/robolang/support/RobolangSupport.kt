package robotran.robolang.support

import robotran.brick.kind.BrickKind
import robotran.hub.model.HubModel
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CodeTokenKind
import robotran.languagesupport.LanguageSupport
import robotran.languagesupport.ProgramFiles
import robotran.languagesupport.ProgramMeasure
import robotran.languagesupport.SourceFile
import robotran.microbit.model.MicrobitModel
import robotran.robolang.RobolangWords
import robotran.robolang.brickOfRobolang
import robotran.robolang.edit.RobolangSyntax
import robotran.robolang.robolangTokens
import robotran.robolang.robolangTokensOfLines
import robotran.robolang.wording.ChangedWords
import robotran.robolang.wording.changeWords
import robotran.robolang.words.BrickDialect
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.inEnglish
import robotran.robolang.words.vocabularyOf
import robotran.robolang.words.written

object RobolangSupport : LanguageSupport {
    override val language = ProgramLanguage.ROBOLANG
    override val code: CodeSyntax = RobolangSyntax
    override val files: ProgramFiles = RobolangFiles
    override val measure: ProgramMeasure = RobolangMeasure
    override val hasBlocks = true

    override fun inWords(program: String, language: Language): String {
        val changed = (changeWords(program, Vocabulary.of(language)) as? ChangedWords.Success)?.text ?: return program
        // Words have other lengths, so comments beside each other would no longer be below each other.
        val wasLaidOut = changed != program && code.format(program) == program
        return if (wasLaidOut) code.format(changed) ?: changed else changed
    }

    override fun wordsOf(program: String): Language = vocabularyOf(program).language

    override fun pieceInWords(piece: String, language: Language): String = Vocabulary.of(language).written(piece)

    override fun usualWord(word: String, program: String): String = vocabularyOf(program).inEnglish(word)

    override fun translations(brick: BrickKind): List<ShownLanguage> = listOfNotNull(
        ShownLanguage.JAVA.takeIf { brick.java != null },
        ShownLanguage.NQC.takeIf { brick.hasLegoFirmware },
    ).ifEmpty { listOfNotNull(ShownLanguage.PYTHON.takeIf { runsPython(brick) }) }

    private fun runsPython(brick: BrickKind) = HubModel.of(brick) != null || MicrobitModel.of(brick) != null
}

private object RobolangFiles : ProgramFiles(ProgramLanguage.ROBOLANG) {
    override fun brickOf(files: List<SourceFile>): BrickKind? = brickOfRobolang(files.single().text)

    override fun isFor(named: BrickKind, robot: BrickKind): Boolean =
        BrickDialect.of(named).keyword == BrickDialect.of(robot).keyword
}

private object RobolangMeasure : ProgramMeasure {
    override fun linesOfCode(text: String): Int = text.lineSequence().count { line ->
        robolangTokens(line).any { it.kind != CodeTokenKind.COMMENT }
    }

    /** Keywords in English, so that programs in different words are compared. */
    override fun normalTokens(text: String): Sequence<String> {
        val vocabulary = vocabularyOf(text)
        return text.lineSequence().zip(robolangTokensOfLines(text).asSequence()).flatMap { (line, tokens) ->
            tokens.mapNotNull { token ->
                val word = line.substring(token.start, token.end)
                when (token.kind) {
                    CodeTokenKind.COMMENT -> null
                    CodeTokenKind.NAME -> ProgramMeasure.NAME
                    CodeTokenKind.KEYWORD -> RobolangWords.spellingOf(word, vocabulary) ?: word.lowercase()
                    else -> word.lowercase()
                }
            }
        }
    }
}
