package robotran.programs

/**
 * A mistake in a program of either language, or something doubtful, told so that a beginner can mend it.
 *
 * @property file the file it is in; empty if it is in none, as in a program without any.
 * @property range where it is; null if it is at no place of a source.
 * @property message one or two sentences in a learner's words, and what to do instead.
 * @property fix a change that very likely mends it, null where there are several ways.
 */
data class Mistake(
    val file: String,
    val range: TextRange?,
    val message: String,
    val fix: TextFix? = null,
)

/**
 * A piece of one line.
 *
 * @property line from 1.
 * @property column from 1, counted in UTF-16 characters, a tab being one; a byte order mark before the first line does not count.
 * @property endColumn the column after the last character; the same as [column] where something is missing.
 */
data class TextRange(
    val line: Int,
    val column: Int,
    val endColumn: Int,
)

/** A change of a source that an editor can offer: [replacement], in which each line ends with `\n`, in place of [range]. */
data class TextFix(
    val range: TextRange,
    val replacement: String,
)
