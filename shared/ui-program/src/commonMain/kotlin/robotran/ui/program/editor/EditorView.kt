package robotran.ui.program.editor

import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.unit.IntSize
import robotran.languagesupport.CodeTokens
import robotran.languagesupport.TextLines
import robotran.textediting.rows.TextRows
import robotran.textediting.text.TextDocument
import robotran.uikit.*

/** The visible part of a text and its position on the screen. */
@Stable
internal class EditorView {
    /** The scroll offset of the text in pixels. Nothing scrolls sideways: long lines are broken into rows. */
    var scrollY by mutableFloatStateOf(0f)
        private set
    var size by mutableStateOf(IntSize.Zero)
    var geometry by mutableStateOf(EditorGeometry(1f, TextRows(TextLines(""))))

    /** The width of the line numbers in pixels. */
    var gutter by mutableFloatStateOf(0f)

    /** How many characters a row may have. */
    var columns by mutableIntStateOf(TextRows.UNBROKEN)

    private var rows = TextRows(TextLines(""))

    private val max: Float
        get() = (geometry.height + geometry.lineHeight * ROOM_BELOW - size.height).coerceAtLeast(0f)

    /** The rows of [lines]. */
    fun rows(lines: TextLines): TextRows {
        if (rows.columns != columns || rows.lines.text != lines.text) rows = TextRows(lines, columns)
        return rows
    }

    /** The lines, from 0, that are at least partly visible. */
    val visibleLines: IntRange get() = geometry.lineAt(scrollY)..geometry.lineAt(scrollY + size.height)

    /** The number of fully visible rows. */
    val page: Int get() = (size.height / geometry.lineHeight).toInt().coerceAtLeast(2) - 1

    /** Scrolls down by [pixels], limited to the text; returns the distance. */
    fun scrollDown(pixels: Float): Float {
        val before = scrollY
        scrollY = (scrollY + pixels).coerceIn(0f, max)
        return scrollY - before
    }

    /** Corrects the scroll offset after the text has become smaller. */
    fun settle() {
        scrollDown(0f)
    }

    /** Scrolls by the min distance that shows [line], or of a line with more rows than fit the first ones. */
    fun scrollTo(line: Int) {
        val margin = minOf(geometry.lineHeight, (size.height - geometry.lineHeight).coerceAtLeast(0f) / 2)
        val height = minOf(geometry.heightOf(line), size.height - 2 * margin).coerceAtLeast(geometry.lineHeight)
        show(geometry.top(line), height, margin)
    }

    /** Scrolls by the min distance that shows the row of a caret at [column] of [line] of [draft]. */
    fun scrollToCaret(line: Int, column: Int, draft: TextDocument) {
        val margin = minOf(geometry.lineHeight, (size.height - geometry.lineHeight).coerceAtLeast(0f) / 2)
        val row = rows(draft.lines).of(line).rowOf(column)
        show(geometry.top(line) + row * geometry.lineHeight, geometry.lineHeight, margin)
    }

    private fun show(top: Float, height: Float, margin: Float) {
        if (size.height == 0) return
        val below = top + height + margin - size.height
        if (top - margin < scrollY) {
            scrollDown(top - margin - scrollY)
        } else if (below > scrollY) {
            scrollDown(below - scrollY)
        }
    }

    /** Scrolls by the min distance that shows [line] and the notes below it, as far as they fit. */
    fun scrollToNotes(line: Int) {
        val top = geometry.top(line)
        val below = geometry.top(line + 1) - size.height
        if (below > scrollY) scrollDown(minOf(below, top) - scrollY)
        scrollTo(line)
    }

    /** The layout of [line] of [draft]. */
    fun laidOut(line: Int, draft: TextDocument, layouts: LineLayouts, pieces: CodeTokens): LaidOutLine =
        layouts.of(draft.lines.line(line), pieces.startsInComment(line), columns)

    /** The caret's rectangle at [column] of [line] on the screen. */
    fun caretBounds(line: Int, column: Int, draft: TextDocument, layouts: LineLayouts, pieces: CodeTokens): Rect {
        val laidOut = laidOut(line, draft, layouts, pieces)
        // Blanks at the end of a row may reach beyond the edge.
        val x = (gutter + laidOut.x(column)).coerceAtMost((size.width - EDGE).coerceAtLeast(gutter))
        val top = geometry.top(line) + laidOut.rows.rowOf(column) * geometry.lineHeight - scrollY
        return Rect(x, top, x, top + geometry.lineHeight)
    }

    /** The text offset nearest to [position] on the screen. */
    fun offsetAt(position: Offset, draft: TextDocument, layouts: LineLayouts, pieces: CodeTokens): Int {
        val y = position.y + scrollY
        val line = geometry.lineAt(y).coerceIn(0, draft.lines.count - 1)
        val laidOut = laidOut(line, draft, layouts, pieces)
        val row = geometry.rowAt(line, y).coerceAtMost(laidOut.rows.count - 1)
        return draft.lines.offset(line, laidOut.column(row, position.x - gutter).coerceAtLeast(0))
    }

    private companion object {
        /** The space below the text in lines, so that the last line need not be at the edge. */
        const val ROOM_BELOW = 2.5f

        /** The min distance in pixels between the caret and the right edge. */
        const val EDGE = 2f
    }
}
