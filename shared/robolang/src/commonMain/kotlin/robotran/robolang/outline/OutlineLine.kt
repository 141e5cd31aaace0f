package robotran.robolang.outline

import robotran.language.source.Diagnostic
import robotran.language.source.SourceSpan
import robotran.robolang.words.LineForm

/** What a line does to the blocks around it. */
enum class LineRole {
    /** It is empty or has only spaces. */
    BLANK,

    /** It has a comment and nothing else. */
    COMMENT,

    /** It stands in a block without changing any. */
    PLAIN,

    /** It opens a block. */
    OPENS,

    /** `else`: it ends one branch of a block and begins the next. */
    BRANCHES,

    /** It closes a block. */
    CLOSES,
}

/**
 * One line of a program.
 *
 * @property index its place in the program, from 0.
 * @property span the line without its line break.
 * @property end the offset behind its line break.
 * @property depth the number of blocks around it. A line that opens, branches or closes a block is outside that block.
 * @property form what it says; null for blank lines, comments and lines with a mistake.
 * @property parts its words and values in order, without the spaces between them; empty if [form] is null.
 * @property comment its comment from `//`, without spaces behind it; null if there is none.
 * @property error the lexical or syntactic mistake that is reported on it; null if there is none. A block without an
 * `end` has one, although its [form] is known.
 */
class OutlineLine internal constructor(
    val index: Int,
    val span: SourceSpan,
    val end: Int,
    val role: LineRole,
    val depth: Int,
    val form: LineForm?,
    val parts: List<PhrasePart>,
    val comment: SourceSpan?,
    val error: Diagnostic?,
)
