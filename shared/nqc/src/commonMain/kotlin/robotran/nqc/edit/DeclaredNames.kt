package robotran.nqc.edit

import robotran.language.Language
import robotran.nqc.diagnostic.DiagnosticSink
import robotran.nqc.messages.NqcMessages
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Lexer
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** What a name is that a program declares. */
enum class NqcNameKind { VARIABLE, TASK, SUB, FUNCTION, MACRO }

/**
 * A name that a program declares.
 *
 * @property line of the declaration, from 1.
 * @property column from 1.
 */
data class NqcName(val name: String, val kind: NqcNameKind, val line: Int, val column: Int)

/** The names that [source] declares, in its order; the program may have mistakes. Never throws. */
fun nqcNamesIn(source: String): List<NqcName> {
    val lexer = Lexer("", source.take(MOST_CHARACTERS), DiagnosticSink(NqcMessages.of(Language.ENGLISH)))
    val tokens = generateSequence { lexer.next() }.takeWhile { it.kind != TokenKind.END }.toList()
    return tokens.indices.mapNotNull { declaredAt(tokens, it) }
}

private fun declaredAt(tokens: List<Token>, index: Int): NqcName? {
    val token = tokens[index].takeIf { it.kind == TokenKind.NAME } ?: return null
    val before = tokens.getOrNull(index - 1) ?: return null
    val kind = when {
        before.keyword == Keyword.TASK -> NqcNameKind.TASK
        before.keyword == Keyword.SUB -> NqcNameKind.SUB
        before.keyword == Keyword.VOID -> NqcNameKind.FUNCTION
        before.kind == TokenKind.DIRECTIVE && before.text == "define" -> NqcNameKind.MACRO
        before.keyword == Keyword.INT || before.keyword == Keyword.SENSOR -> NqcNameKind.VARIABLE
        before.isSign("&") || before.isSign("*") -> pointerKind(tokens, index)
        before.isSign(",") && isInDeclaration(tokens, index) -> NqcNameKind.VARIABLE
        else -> null
    }
    return kind?.let { NqcName(token.text, it, token.range.line, token.range.column) }
}

/** The name after `int &` or `int *`. */
private fun pointerKind(tokens: List<Token>, index: Int): NqcNameKind? =
    NqcNameKind.VARIABLE.takeIf { tokens.getOrNull(index - 2)?.keyword == Keyword.INT }

/** Whether the name at [index], after a comma, is one of several after `int`. */
private fun isInDeclaration(tokens: List<Token>, index: Int): Boolean {
    var depth = 0
    for (place in index - 1 downTo maxOf(0, index - LONGEST_DECLARATION)) {
        val token = tokens[place]
        when {
            token.isSign(")") || token.isSign("]") -> depth++
            token.isSign("(") || token.isSign("[") -> if (--depth < 0) return false
            depth == 0 && token.keyword == Keyword.INT -> return true

            token.kind == TokenKind.DIRECTIVE || token.isSign(
                ";",
            ) || token.isSign("{") || token.isSign("}") -> return false
        }
    }
    return false
}

/** Names further down are not found, because this runs on every keystroke. */
private const val MOST_CHARACTERS = 100_000

/** Max tokens of a declaration of several variables. */
private const val LONGEST_DECLARATION = 200
