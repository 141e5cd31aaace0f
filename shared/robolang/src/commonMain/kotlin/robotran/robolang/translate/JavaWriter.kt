package robotran.robolang.translate

import robotran.robolang.syntax.Token

/**
 * Collects lines of Java, each with its indentation and its source line.
 *
 * @param depth the indentation depth of the first line.
 * @param sourceLines the lines of the program, whose blank lines are kept; null to keep none.
 */
internal class JavaWriter(private var depth: Int = 0, private val sourceLines: SourceLines? = null) {
    private val texts = mutableListOf<String>()
    private val origins = mutableListOf<Int>()
    private var comments = ArrayDeque<Token>()
    private var latestSourceLine = LineMap.NO_LINE

    /** Whether the following code is unreachable: Java rejects such lines, so they become comments. */
    var isUnreachable = false

    val text: String get() = texts.joinToString("") { "$it\n" }

    val lineMap: LineMap get() = LineMap(origins.toList())

    /** Writes [newComments], in order, above or after the lines with the same source lines. */
    fun takeComments(newComments: List<Token>) {
        comments = ArrayDeque(newComments)
    }

    /** Writes [text], after the comments above [sourceLine] and with the one on it. */
    fun line(text: String, sourceLine: Int = LineMap.NO_LINE, note: String? = null) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        val own = comments.firstOrNull()?.takeIf { it.range.line == sourceLine }
        if (own != null) comments.removeFirst()
        val behind = listOfNotNull(own?.let(::javaComment), note?.let { "// $it" }).joinToString(" ")
        write(if (behind.isEmpty()) text else "$text $behind".trim(), sourceLine)
    }

    /** Writes the comments above [sourceLine]. */
    fun commentsAbove(sourceLine: Int) {
        while (comments.isNotEmpty() && comments.first().range.line < sourceLine) comment(comments.removeFirst())
    }

    /** Writes the remaining comments. */
    fun commentsLeft() {
        while (comments.isNotEmpty()) comment(comments.removeFirst())
    }

    fun blank() {
        if (texts.isNotEmpty() && texts.last().isNotEmpty() && !texts.last().endsWith("{")) write("", LineMap.NO_LINE)
    }

    fun open(text: String, sourceLine: Int = LineMap.NO_LINE, note: String? = null) {
        line("$text {", sourceLine, note)
        depth++
    }

    /** Begins a block whose first line is written. */
    fun enter() {
        depth++
    }

    /** Ends one block and begins the next, such as `} else {`. */
    fun reopen(text: String, sourceLine: Int) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        depth--
        open("} $text", sourceLine)
    }

    fun close(sourceLine: Int = LineMap.NO_LINE) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        depth--
        line("}", sourceLine)
    }

    /** Writes lines without a source line, at the current depth. */
    fun lines(text: String) = text.lines().forEach { write(it, LineMap.NO_LINE) }

    /** Writes all lines of [other], which has its own depth. */
    fun append(other: JavaWriter) {
        blank()
        texts += other.texts
        origins += other.origins
    }

    private fun comment(comment: Token) = write(javaComment(comment), comment.range.line)

    /** Keeps a blank line of the program, except at the end of a block. */
    private fun blankAbove(text: String, sourceLine: Int) {
        if (sourceLine == LineMap.NO_LINE || sourceLine == latestSourceLine) return
        latestSourceLine = sourceLine
        if (sourceLines?.isBlankAbove(sourceLine) == true && !text.startsWith("}")) blank()
    }

    private fun write(text: String, sourceLine: Int) {
        blankAbove(text, sourceLine)
        val shown = if (isUnreachable && text.isNotEmpty() && !text.startsWith("//")) "// $text" else text
        texts += if (shown.isEmpty()) "" else INDENTATION.repeat(depth) + shown
        origins += sourceLine
    }

    private companion object {
        const val INDENTATION = "    "

        /** Java interprets Unicode escapes such as `\u0041` even in comments. */
        fun javaComment(comment: Token): String = comment.text.trimEnd().replace('\\', '/')
    }
}
