package robotran.robolang.edit

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robolangTokens
import robotran.robolang.words.Keyword
import robotran.robolang.words.OPENERS
import robotran.robolang.words.Vocabulary
import robotran.robolang.words.vocabularyOf

/** What editors ask about Robolang. */
internal object RobolangSyntax : CodeSyntax {
    override val indent = "  "
    override val blockEnds = Vocabulary.all.flatMapTo(mutableSetOf()) {
        listOf(it.text(Keyword.END), it.text(Keyword.ELSE))
    }
    override val keys = listOf("(", ")", "=", "<", ">", "+", "-", "*", "/", "\"", "[", "]", ",")

    override fun blockEffect(line: String): BlockEffect {
        val word = line.trimStart().takeWhile(::isInWord)
        return when (val keyword = vocabularyOf(line).keyword(word)) {
            Keyword.END -> BlockEffect(closes = true, opens = false)
            Keyword.ELSE -> BlockEffect(closes = true, opens = true)
            else -> BlockEffect(closes = false, opens = keyword in OPENERS)
        }
    }

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        LineTokens(robolangTokens(line), endsInComment = false)

    override fun complete(request: CompletionRequest): CompletionList? = completeRobolang(request)

    override fun format(source: String): String? =
        (formatRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)) as? FormatResult.Success)?.text
}

internal fun isInWord(character: Char): Boolean = character == '_' || character.isLetterOrDigit()
