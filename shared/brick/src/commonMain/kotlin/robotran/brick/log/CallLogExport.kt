package robotran.brick.log

import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.log.Iterable
import robotran.rcxrom.log.RomLogEntry

/** The entries as log text, one line each, see [RomLogEntry.text]. */
fun Iterable<RomLogEntry>.toLogText(): String = joinToString("") { it.text + "\n" }

/**
 * The entries as comma-separated values (RFC 4180) for a spreadsheet; the first line holds the column names. The line
 * of a firmware call is empty; in a program with several files the file comes first, as in `Robot.java:7`. Codes and
 * pointers are hexadecimal.
 */
fun Iterable<RomLogEntry>.toCsv(): String =
    (listOf(COLUMNS) + map(::cells)).joinToString("") { row -> row.joinToString(",") { quoted(it) } + CSV_LINE_END }

private val COLUMNS = listOf("milliseconds", "group", "address", "arguments", "meaning", "line", "outcome")

private fun cells(entry: RomLogEntry): List<String> {
    val words = RomCallText.of(entry.call).split(' ')
    return listOf(
        entry.milliseconds.toString(),
        CallGroup.of(entry.call.address).name.lowercase(),
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
