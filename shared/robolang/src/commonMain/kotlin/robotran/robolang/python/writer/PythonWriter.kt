package robotran.robolang.python.writer

import robotran.robolang.syntax.Token
import robotran.robolang.translate.CodeWriter
import robotran.robolang.translate.LineMap
import robotran.robolang.translate.SourceLines

/** Collects lines of Python. A block without a line gets `pass`. */
internal class PythonWriter(depth: Int = 0, sourceLines: SourceLines? = null) : CodeWriter(depth, sourceLines) {
    private val firstLines = ArrayDeque<Int>()

    val isEmpty: Boolean get() = size == 0

    override fun comment(text: String): String = "# $text"

    override fun commentOf(comment: Token): String = ("#" + comment.text.trimEnd().removePrefix("//")).trimEnd()

    override fun opens(text: String): Boolean = text.endsWith(":") && !text.trimStart().startsWith("#")

    override fun behindOf(text: String, behind: String): String = if (behind.isEmpty()) text else "$text  $behind"

    fun open(text: String, sourceLine: Int = LineMap.NO_LINE, note: String? = null) {
        line("$text:", sourceLine, note)
        enterBlock()
    }

    /** Begins a block whose first line is written. */
    fun enterBlock() {
        enter()
        firstLines.addLast(size)
    }

    /** Ends the innermost block, after the comments up to and on [lastLine]. */
    fun close(lastLine: Int = LineMap.NO_LINE) {
        if (lastLine != LineMap.NO_LINE) commentsAbove(lastLine + 1)
        val first = firstLines.removeLast()
        val isEmpty = (first until size).none { place -> lineAt(place).trim().let { it.isNotEmpty() && it[0] != '#' } }
        if (isEmpty) write("pass", LineMap.NO_LINE)
        exit()
    }

    /** Ends what [enter] began. */
    fun leave() = exit()

    /** Two blank lines, as around a function. */
    fun gap() {
        if (size == 0) return
        if (lineAt(size - 1).isNotEmpty()) write("", LineMap.NO_LINE)
        if (size > 1 && lineAt(size - 2).isNotEmpty()) write("", LineMap.NO_LINE)
    }
}
