package robotran.language.source

/**
 * A range within one line of a source.
 *
 * @property line from 1; 0 if the place is unknown.
 * @property column from 1, in UTF-16 characters; a tab counts as one, a byte order mark before the first line does not
 * count.
 * @property endColumn the column after the last character.
 * @property file the name of the file, where a compiler reads several that include each other; otherwise empty.
 */
data class SourceRange(val line: Int, val column: Int, val endColumn: Int, val file: String = "") {
    /** The empty range after the last character. */
    val end: SourceRange get() = copy(column = endColumn)

    /** From the first character of this range to the last one of [last], if both are on one line; otherwise this. */
    fun to(last: SourceRange): SourceRange = if (last.file == file && last.line == line && last.endColumn > column) {
        copy(endColumn = last.endColumn)
    } else {
        this
    }
}
