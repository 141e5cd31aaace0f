package robotran.brick.log

/** The entries as log text, one line each, see [LoggedCall.text]. */
fun Iterable<LoggedCall>.toLogText(): String = joinToString("") { it.text + "\n" }

/**
 * The entries as comma-separated values (RFC 4180) for a spreadsheet; the first line holds the column names. The line
 * of a firmware call is empty; in a program with several files the file comes first, as in `Robot.java:7`. Codes and
 * pointers are hexadecimal.
 */
fun Iterable<LoggedCall>.toCsv(): String =
    (listOf(COLUMNS) + map(::cells)).joinToString("") { row -> row.joinToString(",") { quoted(it) } + CSV_LINE_END }

private val COLUMNS = listOf("milliseconds", "group", "address", "arguments", "meaning", "line", "outcome")

private fun cells(entry: LoggedCall): List<String> {
    val words = entry.callText.split(' ')
    return listOf(
        entry.milliseconds.toString(),
        entry.group.name.lowercase(),
        words.first(),
        words.drop(1).joinToString(" "),
        entry.meaning,
        entry.sourceLocation,
        entry.outcome.name.lowercase(),
    )
}

private fun quoted(cell: String): String =
    if (cell.any { it == ',' || it == '"' || it == '\n' || it == '\r' }) "\"${cell.replace("\"", "\"\"")}\"" else cell

private const val CSV_LINE_END = "\r\n"
