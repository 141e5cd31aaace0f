package robotran.robolang.translate

import robotran.robolang.syntax.Token

/**
 * Collects lines of a translation, each with its indentation and its source line, and puts the comments of the program
 * where they belong.
 *
 * @param depth the indentation depth of the first line.
 * @param sourceLines the lines of the program, whose blank lines are kept; null to keep none.
 */
internal abstract class CodeWriter(private var depth: Int, private val sourceLines: SourceLines?) {
    private val texts = mutableListOf<String>()
    private val origins = mutableListOf<Int>()
    private var comments = ArrayDeque<Token>()
    private var latestSourceLine = LineMap.NO_LINE

    val text: String get() = texts.joinToString("") { "$it\n" }

    val lineMap: LineMap get() = LineMap(origins.toList())

    /** The comment that begins with [text], in the language of the translation. */
    protected abstract fun comment(text: String): String

    /** The text of a comment of the program, in the language of the translation. */
    protected abstract fun commentOf(comment: Token): String

    /** Whether the line [text] begins a block. */
    protected abstract fun opens(text: String): Boolean

    /** Whether the line [text] ends one. */
    protected open fun closes(text: String): Boolean = false

    /** [text] as it is written. */
    protected open fun shown(text: String): String = text

    /** Writes [newComments], in order, above or after the lines with the same source lines. */
    fun takeComments(newComments: List<Token>) {
        comments = ArrayDeque(newComments)
    }

    /** Writes [text], after the comments above [sourceLine] and with the one on it. */
    fun line(text: String, sourceLine: Int = LineMap.NO_LINE, note: String? = null) {
        if (sourceLine != LineMap.NO_LINE) commentsAbove(sourceLine)
        val own = comments.firstOrNull()?.takeIf { it.range.line == sourceLine }
        if (own != null) comments.removeFirst()
        val behind = listOfNotNull(own?.let(::commentOf), note?.let(::comment)).joinToString(" ")
        write(behindOf(text, behind), sourceLine)
    }

    /** [text] with the comment [behind] it. */
    protected open fun behindOf(text: String, behind: String): String =
        if (behind.isEmpty()) text else "$text $behind".trim()

    /** Writes the comments above [sourceLine]. */
    fun commentsAbove(sourceLine: Int) {
        while (comments.isNotEmpty() && comments.first().range.line < sourceLine) writeComment(comments.removeFirst())
    }

    /** What comes above the lines of [sourceLine]: its comments, and a blank line if the program has one there. */
    fun begin(sourceLine: Int) {
        commentsAbove(sourceLine)
        blankAbove("", sourceLine)
    }

    /** Writes the remaining comments. */
    fun commentsLeft() {
        while (comments.isNotEmpty()) writeComment(comments.removeFirst())
    }

    fun blank() {
        if (texts.isNotEmpty() && texts.last().isNotEmpty() && !opens(texts.last())) write("", LineMap.NO_LINE)
    }

    /** Begins a block whose first line is written. */
    fun enter() {
        depth++
    }

    /** Ends a block, without a line. */
    protected fun exit() {
        depth--
    }

    /** Writes lines without a source line, at the current depth. */
    fun lines(text: String) = text.lines().forEach { write(it, LineMap.NO_LINE) }

    /** Writes all lines of [other], which has its own depth. */
    fun append(other: CodeWriter) {
        blank()
        texts += other.texts
        origins += other.origins
    }

    /** How many lines are written. */
    protected val size: Int get() = texts.size

    /** Line [place], counted from 0. */
    protected fun lineAt(place: Int): String = texts[place]

    protected fun write(text: String, sourceLine: Int) {
        blankAbove(text, sourceLine)
        val shown = shown(text)
        texts += if (shown.isEmpty()) "" else INDENTATION.repeat(depth) + shown
        origins += sourceLine
    }

    private fun writeComment(comment: Token) = write(commentOf(comment), comment.range.line)

    /** Keeps a blank line of the program, except at the end of a block. */
    private fun blankAbove(text: String, sourceLine: Int) {
        if (sourceLine == LineMap.NO_LINE || sourceLine == latestSourceLine) return
        latestSourceLine = sourceLine
        if (sourceLines?.isBlankAbove(sourceLine) == true && !closes(text)) blank()
    }

    private companion object {
        const val INDENTATION = "    "
    }
}
