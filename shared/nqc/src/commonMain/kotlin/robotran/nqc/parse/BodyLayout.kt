package robotran.nqc.parse

import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** Warns of lines that look as if they belonged to an `if` or a loop. */
internal class BodyLayout(private val reader: TokenReader) {
    /**
     * Reads the body of the statement that begins with [word] by [read], and warns if the line below it begins where the
     * body does.
     */
    fun <T> body(word: Token, read: () -> T): T {
        val first = reader.token
        val isBelow = isTyped(first) && !first.isSign("{") && isOnOtherLine(first, reader.previous)
        val indent = if (isBelow) indentBefore(word) else 0
        val body = read()
        val next = reader.token
        if (isBelow && isTyped(word) && first.range.column > indent && next.range.column == first.range.column &&
            isOnOtherLine(next, reader.previous) && next.range.file == first.range.file && canFollow(next)
        ) {
            val message = reader.sink.messages.misleadingIndent(word.text)
            reader.sink.report(NqcDiagnosticCode.MISLEADING_INDENT, next.range, message)
        }
        return body
    }

    private fun isTyped(token: Token) = token.macro == null

    private fun isOnOtherLine(token: Token, before: Token) =
        token.range.line > before.range.line && token.range.file == before.range.file

    private fun canFollow(token: Token) = isTyped(token) && token.kind != TokenKind.END && !token.isSign("}") &&
        token.keyword !in OTHERS && token.keyword?.group != KeywordGroup.UNIT

    /** The column in which the line of [word] begins. */
    private fun indentBefore(word: Token): Int {
        var column = word.range.column
        for (distance in 0 downTo -LONGEST_LINE) {
            val token = reader.peek(distance)
            if (token.range.line == word.range.line && token.range.file == word.range.file && isTyped(token)) {
                column = minOf(column, token.range.column)
            }
        }
        return column
    }

    private companion object {
        val OTHERS = setOf(Keyword.ELSE, Keyword.CATCH, Keyword.CASE, Keyword.DEFAULT, Keyword.WHILE)

        /** Max tokens that are looked at to find where a line begins. */
        const val LONGEST_LINE = 40
    }
}
