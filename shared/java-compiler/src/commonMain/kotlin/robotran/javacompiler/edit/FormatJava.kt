package robotran.javacompiler.edit

import robotran.languagesupport.CodeToken
import robotran.languagesupport.CodeTokenKind

/**
 * Formats Java. Each block level is indented by four spaces, and a continued line by eight more. There are no trailing
 * spaces and no two empty lines in a row, and the text ends in `\n`. The content of each line stays as it is.
 * Formatting a formatted text changes nothing. Never throws for any [source].
 */
internal fun formatJava(source: String): String {
    val layout = JavaFormatter()
    val lines = source.replace("\r\n", "\n").replace('\r', '\n').split('\n').map(layout::formatted)
    val kept = lines.filterIndexed { index, line -> line.isNotEmpty() || (index > 0 && lines[index - 1].isNotEmpty()) }
    val text = kept.dropWhile { it.isEmpty() }.dropLastWhile { it.isEmpty() }.joinToString("\n")
    return if (text.isEmpty()) "" else text + "\n"
}

/** Formats a source line by line and tracks the indentation. */
private class JavaFormatter {
    /** The open brackets, with the indentation of the lines inside them. */
    private val open = ArrayDeque<Bracket>()
    private var isInComment = false
    private var commentIndent = 0

    /** The extra indentation of a line because the statement before it has not ended. */
    private var continuation = 0

    fun formatted(line: String): String {
        val startsInComment = isInComment
        val content = line.trim()
        val parts = tokenizeJavaLine(content, startsInComment, brick = null)
        isInComment = parts.endsInComment
        if (content.isEmpty()) return ""
        if (startsInComment) {
            val indent = if (content.startsWith('*')) commentIndent + 1 else commentIndent
            trackBrackets(content, parts.tokens, commentIndent)
            return blanks(indent) + content
        }
        val indent = indentOf(content)
        if (isInComment) commentIndent = indent
        trackBrackets(content, parts.tokens, indent)
        return blanks(indent) + content
    }

    private fun indentOf(content: String): Int {
        val first = content.first()
        val bracket = open.lastOrNull() ?: return if (first == '{') 0 else continuation
        if (first == '}' && bracket.sign == '{') return bracket.outside
        val extra = if (first == '{') 0 else continuation
        return bracket.inside + extra
    }

    private fun trackBrackets(content: String, tokens: List<CodeToken>, indent: Int) {
        val code = tokens.filter { it.kind != CodeTokenKind.COMMENT }
        if (code.isEmpty()) return
        val lineStart = if (continuation > 0 && content.first() != '{') indent - continuation else indent
        for (token in code.filter { it.kind == CodeTokenKind.SIGN }) {
            when (val sign = content[token.start]) {
                '{' -> open.addLast(Bracket(sign, lineStart, lineStart + STEP))
                '(', '[' -> open.addLast(Bracket(sign, lineStart, lineStart + 2 * STEP))
                '}', ')', ']' -> close(opening(sign))
            }
        }
        continuation = continuationAfter(content, code)
    }

    private fun close(sign: Char) {
        if (open.any { it.sign == sign }) {
            while (open.last().sign != sign) open.removeLast()
            open.removeLast()
        }
    }

    private fun continuationAfter(content: String, code: List<CodeToken>): Int {
        if (open.lastOrNull()?.sign.let { it == '(' || it == '[' }) return 0
        val last = code.last()
        val end = content.substring(last.start, last.end)
        val words = code.takeWhile {
            it.kind != CodeTokenKind.SIGN || content[it.start] == '}'
        }.map { content.substring(it.start, it.end) }
        val keyword = words.firstOrNull { it != "}" }
        return when {
            end == ";" || end == "{" || end == "}" || end == "," || end == ":" -> 0
            end == ")" && keyword in HEADERS -> STEP
            end == "else" || end == "do" || (end == ")" && "else" in words) -> STEP
            else -> 2 * STEP
        }
    }

    private class Bracket(val sign: Char, val outside: Int, val inside: Int)

    private companion object {
        const val STEP = 4
        val HEADERS = setOf("if", "for", "while", "else")

        fun blanks(count: Int) = " ".repeat(count)

        fun opening(closing: Char) = when (closing) {
            '}' -> '{'
            ')' -> '('
            else -> '['
        }
    }
}
