package robotran.nqc.edit

import robotran.language.Language
import robotran.languagesupport.CodeTokenKind
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.messages.NqcMessages
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.KeywordGroup
import robotran.nqc.syntax.Lexer
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.syntax.isDigit
import robotran.nqc.syntax.isNamePart

/** What kind of thing can be written somewhere. */
internal enum class CaretContext { DIRECTIVE, TASK_NAME, NEW_NAME, OUTSIDE, STATEMENT, VALUE }

/**
 * Where the caret of an editor is.
 *
 * @property start where the word before the caret begins.
 * @property call the function in whose arguments it is; null if in none.
 * @property argument the number of the argument, from 0.
 */
internal class CaretPlace private constructor(
    val start: Int,
    val typed: String,
    val context: CaretContext,
    val call: String?,
    val argument: Int,
    private val line: Int,
    private val column: Int,
) {
    /** Whether [name] is the word that is being written. */
    fun isAt(name: NqcName): Boolean = name.line == line && name.column == column

    companion object {
        private val CONDITIONS = setOf(Keyword.IF, Keyword.WHILE, Keyword.REPEAT, Keyword.SWITCH, Keyword.FOR)

        /** The place at [caret] of [source]; null in comments, texts and numbers. */
        fun of(source: String, caret: Int): CaretPlace? {
            if (caret !in 0..source.length) return null
            var start = caret
            while (start > 0 && isNamePart(source[start - 1])) start--
            if (start > 0 && source[start - 1] == '#') start--
            val typed = source.substring(start, caret)
            if (typed.isNotEmpty() && isDigit(typed.first())) return null
            val lineStart = source.lastIndexOfAny(charArrayOf('\n', '\r'), start - 1) + 1
            if (isInCommentOrText(source, lineStart, start)) return null
            val tokens = tokensOf(source.substring(0, start))
            val call = openCall(tokens)
            val context = if (isDirective(source, lineStart, start)) CaretContext.DIRECTIVE else contextAfter(tokens)
            val line = source.substring(0, lineStart).count { it == '\n' } + 1
            return CaretPlace(start, typed, context, call?.first, call?.second ?: 0, line, start - lineStart + 1)
        }

        private fun tokensOf(text: String): List<Token> {
            val lexer = Lexer("", text, DiagnosticSink(NqcMessages.of(Language.ENGLISH)))
            return generateSequence { lexer.next() }.takeWhile { it.kind != TokenKind.END }.toList()
        }

        private fun isDirective(source: String, lineStart: Int, start: Int): Boolean {
            val before = source.substring(lineStart, start).trim()
            return before == "#" || (before.isEmpty() && source.getOrNull(start) == '#')
        }

        private fun isInCommentOrText(source: String, lineStart: Int, start: Int): Boolean {
            var isInComment = false
            source.substring(0, lineStart).lineSequence().forEach {
                isInComment =
                    nqcTokens(it, isInComment).endsInComment
            }
            val line = source.substring(lineStart, start)
            val tokens = nqcTokens(line, isInComment)
            val last = tokens.tokens.lastOrNull()?.takeIf { it.end == line.length } ?: return tokens.endsInComment
            val isOpenText = last.kind == CodeTokenKind.TEXT && (last.end == last.start + 1 || !line.endsWith('"'))
            val isLineComment = last.kind == CodeTokenKind.COMMENT && !line.endsWith("*/")
            return tokens.endsInComment || isOpenText || isLineComment
        }

        private fun contextAfter(tokens: List<Token>): CaretContext {
            val last = tokens.lastOrNull() ?: return CaretContext.OUTSIDE
            val isInside = tokens.count { it.isSign("{") } > tokens.count { it.isSign("}") }
            return when {
                last.keyword == Keyword.START || last.keyword == Keyword.STOP -> CaretContext.TASK_NAME
                last.keyword?.group == KeywordGroup.UNIT || last.keyword == Keyword.INT -> CaretContext.NEW_NAME

                last.isSign("{") || last.isSign("}") || last.isSign(";") || last.isSign(":") ||
                    last.kind == TokenKind.END_OF_DIRECTIVE || endsHead(tokens) ||
                    last.keyword == Keyword.ELSE || last.keyword == Keyword.DO -> {
                    if (isInside) CaretContext.STATEMENT else CaretContext.OUTSIDE
                }

                else -> CaretContext.VALUE
            }
        }

        /** Whether the last token closes the brackets of `if (..)` or a loop. */
        private fun endsHead(tokens: List<Token>): Boolean {
            if (!tokens.last().isSign(")")) return false
            var depth = 0
            for (index in tokens.indices.reversed()) {
                if (tokens[index].isSign(")")) depth++
                if (tokens[index].isSign("(") && --depth == 0) {
                    val head = tokens.getOrNull(index - 1)
                    return head?.keyword in CONDITIONS || head?.text == "until"
                }
            }
            return false
        }

        /** The function in whose brackets the end of [tokens] is, and the number of the argument. */
        private fun openCall(tokens: List<Token>): Pair<String, Int>? {
            var depth = 0
            var commas = 0
            for (index in tokens.indices.reversed()) {
                val token = tokens[index]
                when {
                    token.isSign(";") || token.isSign("{") || token.isSign("}") -> return null
                    token.isSign(")") -> depth++
                    token.isSign("(") && depth > 0 -> depth--

                    token.isSign("(") -> {
                        val name = tokens.getOrNull(index - 1)?.takeIf { it.kind == TokenKind.NAME } ?: return null
                        return name.text to commas
                    }

                    token.isSign(",") && depth == 0 -> commas++
                }
            }
            return null
        }
    }
}
