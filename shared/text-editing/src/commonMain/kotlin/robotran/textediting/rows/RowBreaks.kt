package robotran.textediting.rows

/**
 * [line] in rows of at most [columns] cells. It is broken before a remark behind code, behind a blank, or else beside an
 * operator, and within a word only where a row has none of these. Rows below the first are indented a little more than the line begins.
 */
fun rowsOf(line: String, columns: Int): LineRows {
    val shown = ShownLine(line)
    val text = shown.text
    val indent = minOf(text.length - text.trimStart().length + HANGING, columns / 2)
    val starts = mutableListOf(0)
    var end = rowEnd(text, 0, columns)
    while (end < text.length) {
        starts += end
        end = rowEnd(text, end, columns - indent)
    }
    return LineRows(shown, indent, starts.toIntArray())
}

/** Whether the part of [text] from [start] to before [end] surely takes one row of [columns] cells. */
internal fun fitsOneRow(text: String, start: Int, end: Int, columns: Int): Boolean {
    if (end - start > columns) return false
    for (place in start..<end) if (text[place] == '\t' || text[place] >= FIRST_WIDE) return false
    return true
}

/** How wide [character] is in a monospaced font: letters of East Asia and emoji are twice as wide as others. */
internal fun cellsOf(character: Char): Int = when {
    character < FIRST_WIDE -> 1
    character.isLowSurrogate() -> 0
    else -> 2
}

private fun rowEnd(text: String, start: Int, room: Int): Int {
    var full = start
    var cells = 0
    while (full < text.length && cells + cellsOf(text[full]) <= room) cells += cellsOf(text[full++])
    // A row takes at least one character, however wide.
    if (full == start && full < text.length) full++
    while (full < text.length && text[full].isLowSurrogate()) full++
    if (full == text.length) return full
    if (text[full] == ' ') return blanksEnd(text, full)
    val word = blanksEnd(text, start)
    val places = full downTo word + 1
    val remark = places.lastOrNull { text[it - 1] == ' ' && text.startsWith("//", it) }
    if (remark != null) return remark
    val blank = places.firstOrNull { text[it - 1] == ' ' }
    if (blank != null && (blank - start) * SHORT_ROW >= room) return blank
    return places.firstOrNull { isBesideOperator(text, it) } ?: blank ?: full
}

private fun blanksEnd(text: String, from: Int): Int {
    var end = from
    while (end < text.length && text[end] == ' ') end++
    return end
}

/** Whether a row may begin at [place]: behind an operator or a comma, or before the dot of a call. */
private fun isBesideOperator(text: String, place: Int): Boolean {
    val before = text[place - 1]
    val after = text[place]
    if (after == '.') return before.isLetter() || before == ')'
    return before in OPERATORS && after !in OPERATORS && after !in CLOSING
}

private const val OPERATORS = "+-*/%=<>&|,;(["
private const val CLOSING = ")];,"
private const val HANGING = 4

/** A row that would be shorter than this part of the room is broken beside an operator, if it can be. */
private const val SHORT_ROW = 3

/** The first character that may be wide (Hangul). */
private const val FIRST_WIDE = '\u1100'
