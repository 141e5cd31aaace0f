package robotran.textediting

import robotran.languagesupport.TextLines

/**
 * Moves marks on lines, counted from 1, with the text of their lines when [edit] changes [before]. A mark on a deleted
 * line is removed. If lines are replaced by as many or more lines, the marks keep their line numbers.
 */
fun Set<Int>.movedWith(edit: TextEdit, before: TextLines): Set<Int> {
    if (isEmpty()) return this
    val first = before.lineOf(edit.start) + 1
    val removed = edit.removed.count { it == '\n' }
    val inserted = edit.inserted.count { it == '\n' }
    if (removed == 0 && inserted == 0) return this
    // Text inserted before the first word of a line moves that line down.
    val isBeforeWords = edit.start <= before.start(first - 1) + indentOf(before.line(first - 1)).length
    val pushesFirst = isBeforeWords && removed == 0
    val takesFirst = isBeforeWords && removed > 0 && edit.inserted.substringBefore('\n').isBlank()
    return mapNotNullTo(mutableSetOf()) { line ->
        when {
            line < first || (line == first && !pushesFirst && !takesFirst) -> line
            line == first && takesFirst -> null
            line > first + removed || removed == 0 -> line + inserted - removed
            line - first <= inserted -> line
            line == first + removed && keepsLastLine(edit, before, line) -> line + inserted - removed
            else -> null
        }
    }
}

/** Whether [edit] leaves the text of the last line that it reaches intact. */
private fun keepsLastLine(edit: TextEdit, before: TextLines, line: Int): Boolean = line <= before.count &&
    edit.start + edit.removed.length <= before.start(line - 1) + indentOf(before.line(line - 1)).length
