package robotran.languagesupport

/**
 * How a language with braces is laid out.
 *
 * @property heads the words that begin a line which a statement must follow, if it ends in `)`.
 * @property openEnds the words behind which a statement must follow.
 * @property hasDirectives whether lines with `#` begin at the left.
 */
class BraceLayout(val heads: Set<String>, val openEnds: Set<String>, val hasDirectives: Boolean = false)

/**
 * Formats a program. Each block level is indented by four spaces, a continued line by eight more. There are no trailing
 * spaces and no two empty lines in a row, and the text ends in `\n`. The content of each line stays as it is. Formatting a
 * formatted text changes nothing. Never throws for any [source].
 */
internal fun formatBraces(source: String, layout: BraceLayout, tokens: (String, Boolean) -> LineTokens): String {
    val formatter = BraceFormatter(layout, tokens)
    val lines = source.replace("\r\n", "\n").replace('\r', '\n').split('\n').map { formatter.formatted(it) }
    val kept = lines.filterIndexed { index, line -> line.isNotEmpty() || (index > 0 && lines[index - 1].isNotEmpty()) }
    val text = kept.dropWhile { it.isEmpty() }.dropLastWhile { it.isEmpty() }.joinToString("\n")
    return if (text.isEmpty()) "" else text + "\n"
}

/** Formats a source line by line. */
private class BraceFormatter(private val layout: BraceLayout, private val tokens: (String, Boolean) -> LineTokens) {
    /** The open brackets, the innermost last. */
    private val open = mutableListOf<Bracket>()
    private var isInComment = false
    private var isInDirective = false
    private var commentIndent = 0

    /** The additional indentation of a line because the statement before it goes on. */
    private var continuation = 0

    fun formatted(line: String): String {
        val content = line.trim()
        val startsInComment = isInComment
        val found = tokens(content, startsInComment)
        isInComment = found.endsInComment
        val begins = layout.hasDirectives && !startsInComment && content.startsWith('#')
        val isDirective = isInDirective || begins
        isInDirective = isDirective && content.endsWith('\\')
        return when {
            content.isEmpty() -> ""
            startsInComment -> inComment(content, found.tokens)
            isDirective -> if (content.startsWith('#')) content else line.trimEnd()
            else -> code(content, found.tokens)
        }
    }

    private fun inComment(content: String, tokens: List<CodeToken>): String {
        track(content, tokens, commentIndent)
        return blanks(if (content.startsWith('*')) commentIndent + 1 else commentIndent) + content
    }

    private fun code(content: String, tokens: List<CodeToken>): String {
        val indent = indentOf(content.first())
        if (isInComment) commentIndent = indent
        track(content, tokens, indent)
        return blanks(indent) + content
    }

    private fun indentOf(first: Char): Int {
        val bracket = open.lastOrNull()
        val extra = if (first == '{') 0 else continuation
        return if (first == '}' && bracket?.sign == '{') bracket.outside else (bracket?.inside ?: 0) + extra
    }

    /** Opens and closes the brackets of a line that is indented by [indent]. */
    private fun track(content: String, tokens: List<CodeToken>, indent: Int) {
        val code = tokens.filter { it.kind != CodeTokenKind.COMMENT }
        if (code.isEmpty()) return
        val start = if (content.first() == '{') indent else indent - continuation
        for (token in code.filter { it.kind == CodeTokenKind.SIGN && it.end == it.start + 1 }) {
            when (val sign = content[token.start]) {
                '{' -> open += Bracket(sign, start, start + STEP)
                '(', '[' -> open += Bracket(sign, start, start + 2 * STEP)
                '}', ')', ']' -> close(OPENING.getValue(sign))
            }
        }
        continuation = continuationAfter(content, code)
    }

    private fun close(sign: Char) {
        val place = open.indexOfLast { it.sign == sign }
        if (place >= 0) while (open.size > place) open.removeAt(open.lastIndex)
    }

    private fun continuationAfter(content: String, code: List<CodeToken>): Int {
        if (open.lastOrNull()?.sign.let { it == '(' || it == '[' }) return 0
        val words = code.map { content.substring(it.start, it.end) }
        val head = words.dropWhile { it == "}" }.firstOrNull()
        return when (words.last()) {
            ";", "{", "}", ",", ":" -> 0
            in layout.openEnds -> STEP
            ")" -> if (head in layout.heads) STEP else 2 * STEP
            else -> 2 * STEP
        }
    }

    private class Bracket(val sign: Char, val outside: Int, val inside: Int)

    private companion object {
        const val STEP = 4
        val OPENING = mapOf('}' to '{', ')' to '(', ']' to '[')

        fun blanks(count: Int) = " ".repeat(maxOf(0, count))
    }
}
