package robotran.languagesupport

import robotran.brick.kind.BrickKind

/** What an editor asks about texts in a programming language. Nothing here throws for any text. */
interface CodeSyntax {
    /** The indentation of one block level. */
    val indent: String

    /** What begins a comment to the end of the line. */
    val commentMark: String get() = "//"

    /** The words, alone on a line in lower case, that get the indentation of the block which they end. */
    val blockEnds: Set<String>

    /** Whether comments can go over several lines, between `/*` and `*/`. */
    val hasLongComments: Boolean get() = false

    /** The signs above an on-screen keyboard, which has them on its second page. */
    val keys: List<String>

    /** What [line], which begins outside of any comment, does to the indentation of the lines below it. */
    fun blockEffect(line: String): BlockEffect

    /**
     * The tokens of one [line] of a program for a [brick].
     *
     * @param startsInComment whether the line begins inside a comment.
     */
    fun tokens(line: String, startsInComment: Boolean, brick: BrickKind): LineTokens

    /** The brick that the program [lines] names, for its words; null if it names none or has the same words on all. */
    fun brickOf(lines: TextLines): BrickKind? = null

    /** The completions at the caret; null if there are none, as in a comment. */
    fun complete(request: CompletionRequest): CompletionList?

    /** Whether [format] can do anything. */
    val hasFormat: Boolean get() = true

    /** The text [source] laid out in the usual way; null if it cannot be, such as for its mistakes. */
    fun format(source: String): String?

    /** Whether [text] can only be in this language. */
    fun isRecognised(text: String): Boolean = false
}

/** What a line does to the indentation of blocks. */
data class BlockEffect(
    /** Whether it ends a block and so has the indentation of the block's first line. */
    val closes: Boolean,
    /** Whether the lines below it are indented further. */
    val opens: Boolean,
)
