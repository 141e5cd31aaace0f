package robotran.textediting

import robotran.textediting.text.TextLines

/**
 * Where marks on lines, counted from 1, are after [edit] has changed [before]: they move with what is written in their
 * line. A mark whose line was taken out goes with it; where lines were replaced by as many or more, the marks stay on
 * the lines of the same number.
 */
fun Set<Int>.movedWith(edit: TextEdit, before: TextLines): Set<Int> {
    if (isEmpty()) return this
    val first = before.lineOf(edit.start) + 1
    val removed = edit.removed.count { it == '\n' }
    val inserted = edit.inserted.count { it == '\n' }
    if (removed == 0 && inserted == 0) return this
    // What is put in before the first word of a line pushes that line down.
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

/** Whether the last line that [edit] reaches into has something of its own left. */
private fun keepsLastLine(edit: TextEdit, before: TextLines, line: Int): Boolean = line <= before.count &&
    edit.start + edit.removed.length <= before.start(line - 1) + indentOf(before.line(line - 1)).length
