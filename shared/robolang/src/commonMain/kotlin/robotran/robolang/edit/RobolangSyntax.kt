package robotran.robolang.edit

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.languagesupport.BlockEffect
import robotran.languagesupport.CodeSyntax
import robotran.languagesupport.CompletionList
import robotran.languagesupport.CompletionRequest
import robotran.languagesupport.LineTokens
import robotran.robolang.RobolangWords
import robotran.robolang.format.FormatResult
import robotran.robolang.format.formatRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.robolangTokens
import robotran.robolang.words.Keyword

/** What editors ask about Robolang. */
internal object RobolangSyntax : CodeSyntax {
    override val indent = "  "
    override val blockEnds = setOf(Keyword.END.text, Keyword.ELSE.text)
    override val keys = listOf("(", ")", "=", "<", ">", "+", "-", "*", "/", "\"", "[", "]", ",")

    override fun blockEffect(line: String): BlockEffect = when (line.trimStart().takeWhile(::isInWord).lowercase()) {
        Keyword.END.text -> BlockEffect(closes = true, opens = false)
        Keyword.ELSE.text -> BlockEffect(closes = true, opens = true)
        in RobolangWords.openers -> BlockEffect(closes = false, opens = true)
        else -> BlockEffect(closes = false, opens = false)
    }

    override fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens =
        LineTokens(robolangTokens(line), endsInComment = false)

    override fun complete(request: CompletionRequest): CompletionList? = completeRobolang(request)

    override fun format(source: String): String? =
        (formatRobolang(source, messages = RobolangMessages.of(Language.ENGLISH)) as? FormatResult.Success)?.text
}

internal fun isInWord(character: Char): Boolean = character == '_' || character.isLetterOrDigit()
