package robotran.ui.program.editor

import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableFloatStateOf
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.unit.IntSize
import robotran.languagesupport.CodeTokens
import robotran.textediting.text.TextDocument
import robotran.uikit.*

/** The visible part of a text and its position on the screen. */
@Stable
internal class EditorView {
    /** The scroll offset of the text in pixels. */
    var scrollX by mutableFloatStateOf(0f)
        private set
    var scrollY by mutableFloatStateOf(0f)
        private set
    var size by mutableStateOf(IntSize.Zero)
    var geometry by mutableStateOf(EditorGeometry(1f, 1))

    /** The width of the line numbers in pixels. */
    var gutter by mutableFloatStateOf(0f)

    /** The width of the longest line in pixels. */
    var textWidth by mutableFloatStateOf(0f)

    private val max: Offset
        get() = Offset(
            (gutter + textWidth - size.width).coerceAtLeast(0f),
            (geometry.height + geometry.lineHeight * ROOM_BELOW - size.height).coerceAtLeast(0f),
        )

    /** The lines, from 0, that are at least partly visible. */
    val visibleLines: IntRange get() = geometry.lineAt(scrollY)..geometry.lineAt(scrollY + size.height)

    /** The number of fully visible lines. */
    val page: Int get() = (size.height / geometry.lineHeight).toInt().coerceAtLeast(2) - 1

    /** Scrolls down by [pixels], limited to the text; returns the distance. */
    fun scrollDown(pixels: Float): Float {
        val before = scrollY
        scrollY = (scrollY + pixels).coerceIn(0f, max.y)
        return scrollY - before
    }

    /** The same to the right. */
    fun scrollRight(pixels: Float): Float {
        val before = scrollX
        scrollX = (scrollX + pixels).coerceIn(0f, max.x)
        return scrollX - before
    }

    /** Corrects the scroll offset after the text has become smaller. */
    fun settle() {
        scrollDown(0f)
        scrollRight(0f)
    }

    /** Scrolls by the min distance that shows [line] and its offset [x] in pixels. */
    fun scrollTo(line: Int, x: Float?) {
        if (size.height == 0) return
        val top = geometry.top(line)
        val margin = minOf(geometry.lineHeight, (size.height - geometry.lineHeight).coerceAtLeast(0f) / 2)
        val below = top + geometry.lineHeight + margin - size.height
        if (top - margin < scrollY) {
            scrollDown(top - margin - scrollY)
        } else if (below > scrollY) {
            scrollDown(below - scrollY)
        }
        if (x == null) return
        val room = size.width - gutter
        if (x < scrollX + SIDE) {
            scrollRight(x - SIDE - scrollX)
        } else if (x + SIDE > scrollX + room) {
            scrollRight(x + SIDE - room - scrollX)
        }
    }

    /** Scrolls by the min distance that shows [line] and the notes below it, as far as they fit. */
    fun scrollToNotes(line: Int) {
        val top = geometry.top(line)
        val below = geometry.top(line + 1) - size.height
        if (below > scrollY) scrollDown(minOf(below, top) - scrollY)
        scrollTo(line, null)
    }

    /** The caret's rectangle at [column] of [line] on the screen. */
    fun caretBounds(line: Int, column: Int, draft: TextDocument, layouts: LineLayouts, pieces: CodeTokens): Rect {
        val x = gutter + layouts.of(draft.lines.line(line), pieces.startsInComment(line)).x(column) - scrollX
        val top = geometry.top(line) - scrollY
        return Rect(x, top, x, top + geometry.lineHeight)
    }

    /** The text offset nearest to [position] on the screen. */
    fun offsetAt(position: Offset, draft: TextDocument, layouts: LineLayouts, pieces: CodeTokens): Int {
        val line = geometry.lineAt(position.y + scrollY).coerceIn(0, draft.lines.count - 1)
        val column = layouts.of(
            draft.lines.line(line),
            pieces.startsInComment(line),
        ).column(position.x - gutter + scrollX)
        return draft.lines.offset(line, column.coerceAtLeast(0))
    }

    private companion object {
        /** The space below the text in lines, so that the last line need not be at the edge. */
        const val ROOM_BELOW = 2.5f

        /** The min distance in pixels between the caret and the left and right edges. */
        const val SIDE = 24f
    }
}
