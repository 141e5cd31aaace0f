package robotran.textediting

import robotran.textediting.rows.TextRows
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.textediting.text.isWordCharacter
import robotran.textediting.text.widthAt
import robotran.textediting.text.widthBefore

/** The caret movements of the keyboard. */
enum class CaretMove {
    LEFT,
    RIGHT,
    WORD_LEFT,
    WORD_RIGHT,
    UP,
    DOWN,
    PAGE_UP,
    PAGE_DOWN,
    LINE_START,
    LINE_END,
    TEXT_START,
    TEXT_END,
}

/**
 * This text with the caret moved.
 *
 * @param selecting whether the selection extends to the new caret.
 * @param goal the preferred cell for vertical movement, used in rows that are long enough; null for the current one.
 * @param page the number of rows on a page.
 * @param rows how this text is shown.
 */
fun TextDocument.moved(
    move: CaretMove,
    selecting: Boolean,
    goal: Int? = null,
    page: Int = 1,
    rows: TextRows = TextRows(lines),
): TextDocument {
    val leavesSelection = !selecting && !selection.isEmpty
    val caret = when {
        leavesSelection && move == CaretMove.LEFT -> selection.start
        leavesSelection && move == CaretMove.RIGHT -> selection.end
        else -> target(move, page) { by -> rows.vertically(selection.caret, by, goal ?: rows.cellOf(selection.caret)) }
    }
    return copy(selection = TextSelection(if (selecting) selection.anchor else caret, caret))
}

private fun TextDocument.target(move: CaretMove, page: Int, vertically: (Int) -> Int): Int {
    val caret = selection.caret
    return when (move) {
        CaretMove.LEFT -> if (caret > 0) caret - widthBefore(text, caret) else 0
        CaretMove.RIGHT -> if (caret < text.length) caret + widthAt(text, caret) else caret
        CaretMove.WORD_LEFT -> wordStartBefore(text, caret)
        CaretMove.WORD_RIGHT -> wordEndAfter(text, caret)
        CaretMove.UP -> vertically(-1)
        CaretMove.DOWN -> vertically(1)
        CaretMove.PAGE_UP -> vertically(-page)
        CaretMove.PAGE_DOWN -> vertically(page)
        CaretMove.LINE_START -> lineStart()
        CaretMove.LINE_END -> lines.end(lines.lineOf(caret))
        CaretMove.TEXT_START -> 0
        CaretMove.TEXT_END -> text.length
    }
}

/** The start of the line's first word, or the start of the line if the caret is already there. */
private fun TextDocument.lineStart(): Int {
    val line = lines.lineOf(selection.caret)
    val start = lines.start(line)
    val words = start + indentOf(lines.line(line)).length
    return if (selection.caret == words) start else words
}

internal fun wordStartBefore(text: String, offset: Int): Int {
    var position = offset
    while (position > 0 && !isWordCharacter(text[position - 1])) {
        position--
        if (text[position] == '\n') return position
    }
    while (position > 0 && isWordCharacter(text[position - 1])) position--
    return position
}

internal fun wordEndAfter(text: String, offset: Int): Int {
    var position = offset
    while (position < text.length && !isWordCharacter(text[position])) {
        position++
        if (text[position - 1] == '\n') return position
    }
    while (position < text.length && isWordCharacter(text[position])) position++
    return position
}

/** The leading blanks of [line]. */
internal fun indentOf(line: String): String = line.takeWhile { it == ' ' || it == '\t' }
