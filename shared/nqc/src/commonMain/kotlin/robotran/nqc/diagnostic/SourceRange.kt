package robotran.nqc.diagnostic

/**
 * A range within one line of a source file.
 *
 * @property file the name of the file, as the program or an `#include` gives it; empty for the API, which has no file.
 * @property line from 1; 0 if the place is unknown.
 * @property column from 1, in UTF-16 characters; a tab counts as one, a byte order mark does not count.
 * @property endColumn the column after the last character.
 */
data class SourceRange(val file: String, val line: Int, val column: Int, val endColumn: Int) {
    /** The empty range after the last character. */
    val end: SourceRange get() = copy(column = endColumn)

    /** From the first character of this range to the last one of [last], if both are on one line; otherwise this. */
    fun to(last: SourceRange): SourceRange = if (last.file == file && last.line == line &&
        last.endColumn > column
    ) {
        copy(endColumn = last.endColumn)
    } else {
        this
    }

    companion object {
        /** A place in the API. */
        val API = SourceRange("", 0, 0, 0)
    }
}

/**
 * A change of the source that an editor can offer.
 *
 * @property range the text to remove; empty to only insert.
 * @property replacement the text to insert.
 */
data class SourceFix(val range: SourceRange, val replacement: String)
