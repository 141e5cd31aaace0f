package robotran.robolang.translate

import robotran.robolang.syntax.Token

/**
 * Collects lines of Java, or of another language with its braces and comments.
 *
 * @param depth the indentation depth of the first line.
 * @param sourceLines the lines of the program, whose blank lines are kept; null to keep none.
 */
internal class JavaWriter(depth: Int = 0, sourceLines: SourceLines? = null) : CodeWriter(depth, sourceLines) {
    /** Whether the following code is unreachable: Java rejects such lines, so they become comments. */
    var isUnreachable = false

    override fun comment(text: String): String = "// $text"

    /** Java interprets Unicode escapes such as `\u0041` even in comments. */
    override fun commentOf(comment: Token): String = comment.text.trimEnd().replace('\\', '/')

    override fun opens(text: String): Boolean = text.endsWith("{")

    override fun closes(text: String): Boolean = text.startsWith("}")

    override fun shown(text: String): String =
        if (isUnreachable && text.isNotEmpty() && !text.startsWith("//")) "// $text" else text

    fun open(text: String, sourceLine: Int = LineMap.NO_LINE, note: String? = null) {
        line("$text {", sourceLine, note)
        enter()
    }

    /** Ends one block and begins the next, such as `} else {`. */
    fun reopen(text: String, sourceLine: Int) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        exit()
        open("} $text", sourceLine)
    }

    fun close(sourceLine: Int = LineMap.NO_LINE) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        exit()
        line("}", sourceLine)
    }
}
