package robotran.nqc.edit

/**
 * Formats NQC. Each block level is indented by four spaces, a continued line by eight more; lines with `#` begin at the
 * left. There are no trailing spaces and no two empty lines in a row, and the text ends in `\n`. The content of each line
 * stays as it is. Formatting a formatted text changes nothing. Never throws for any [source].
 */
fun formatNqc(source: String): String {
    val layout = NqcLayout()
    val lines = source.replace("\r\n", "\n").replace('\r', '\n').split('\n').map { layout.formatted(it) }
    val kept = lines.filterIndexed { index, line -> line.isNotEmpty() || (index > 0 && lines[index - 1].isNotEmpty()) }
    val text = kept.dropWhile { it.isEmpty() }.dropLastWhile { it.isEmpty() }.joinToString("\n")
    return if (text.isEmpty()) "" else text + "\n"
}

/** Formats a source line by line. */
private class NqcLayout {
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
        val tokens = nqcTokens(content, startsInComment)
        isInComment = tokens.endsInComment
        val isDirective = isInDirective || tokens.tokens.firstOrNull()?.kind == NqcTokenKind.DIRECTIVE
        isInDirective = isDirective && content.endsWith('\\')
        return when {
            content.isEmpty() -> ""
            startsInComment -> inComment(content, tokens.tokens)
            isDirective -> if (content.startsWith('#')) content else line.trimEnd()
            else -> code(content, tokens.tokens)
        }
    }

    private fun inComment(content: String, tokens: List<NqcToken>): String {
        track(content, tokens, commentIndent)
        return blanks(if (content.startsWith('*')) commentIndent + 1 else commentIndent) + content
    }

    private fun code(content: String, tokens: List<NqcToken>): String {
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
    private fun track(content: String, tokens: List<NqcToken>, indent: Int) {
        val code = tokens.filter { it.kind != NqcTokenKind.COMMENT }
        if (code.isEmpty()) return
        val start = if (content.first() == '{') indent else indent - continuation
        for (token in code.filter { it.kind == NqcTokenKind.SIGN && it.end == it.start + 1 }) {
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

    private fun continuationAfter(content: String, code: List<NqcToken>): Int {
        if (open.lastOrNull()?.sign.let { it == '(' || it == '[' }) return 0
        val words = code.map { content.substring(it.start, it.end) }
        val head = words.dropWhile { it == "}" }.firstOrNull()
        return when (words.last()) {
            ";", "{", "}", ",", ":" -> 0
            "else", "do", "catch" -> STEP
            ")" -> if (head in HEADS) STEP else 2 * STEP
            else -> 2 * STEP
        }
    }

    private class Bracket(val sign: Char, val outside: Int, val inside: Int)

    private companion object {
        const val STEP = 4
        val HEADS = "if else while for repeat until switch monitor acquire catch task sub void".split(' ').toSet()
        val OPENING = mapOf('}' to '{', ')' to '(', ']' to '[')

        fun blanks(count: Int) = " ".repeat(maxOf(0, count))
    }
}
