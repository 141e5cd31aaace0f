package robotran.ui.program.editor

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.layout.Layout
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.IntSize
import androidx.compose.ui.unit.dp
import robotran.languagesupport.CodeTokens
import robotran.ui.code.codeColours
import robotran.uikit.*

/**
 * The visible lines of a text with their numbers, and with [notes] between them.
 *
 * @param noteLines the line, from 1, of each note, in order.
 */
@Composable
internal fun EditorSurface(
    paint: EditorPaint,
    pieces: CodeTokens,
    view: EditorView,
    layouts: LineLayouts,
    noteLines: List<Int>,
    modifier: Modifier = Modifier,
    notes: @Composable () -> Unit = {},
) {
    val colours = LocalRobotranColours.current
    val code = codeColours()
    val measurer = rememberTextMeasurer(cacheSize = 0)
    val numbers = remember(measurer, layouts) {
        NumberLayouts(measurer, layouts.style.copy(fontSize = layouts.style.fontSize * NUMBER_SIZE))
    }
    val lines = paint.draft.lines
    val density = LocalDensity.current
    val digits = maxOf(2, lines.count.toString().length)
    val gutter =
        with(density) {
            (layouts.characterWidth * digits * NUMBER_SIZE + (SIGN + GAP).toPx()).coerceAtLeast(GUTTER.toPx())
        }
    val drawing =
        remember(paint, pieces, layouts, colours, code) { EditorDrawing(paint, pieces, view, layouts, colours, code) }
    val gutterDrawing =
        remember(paint, numbers, colours, code) { GutterDrawing(paint.marks, view, numbers, colours, code) }
    Layout(
        content = notes,
        modifier = modifier.clipToBounds().drawBehind {
            with(drawing) { draw() }
            with(gutterDrawing) { draw(lines.count) }
        },
    ) { measurables, constraints ->
        val size = IntSize(constraints.maxWidth, constraints.maxHeight)
        val width = (size.width - gutter.toInt()).coerceAtLeast(0)
        val placed = measurables.map { it.measure(Constraints(minWidth = width, maxWidth = width)) }
        val places = placed.mapIndexed { index, note ->
            NoteBounds((noteLines[index] - 1).coerceIn(0, lines.count - 1), note.height.toFloat())
        }
        view.size = size
        view.gutter = gutter
        view.columns = ((width - ROOM_BEHIND.toPx()) / layouts.characterWidth).toInt().coerceAtLeast(MIN_COLUMNS)
        val geometry = EditorGeometry(layouts.lineHeight, view.rows(lines), places)
        view.geometry = geometry
        view.settle()
        layout(size.width, size.height) {
            placed.forEachIndexed { index, note ->
                val top = geometry.noteTop(index) - view.scrollY
                if (top + note.height > 0 && top < size.height) note.place(gutter.toInt(), top.toInt())
            }
        }
    }
}

/** The numbers are slightly smaller than the text. */
private const val NUMBER_SIZE = 0.86f

/** Space for setting a breakpoint by touch, and for the sign before a number. */
private val GUTTER = 48.dp
private val SIGN = 22.dp

/** The space behind the longest row, so that a caret there is seen. */
private val ROOM_BEHIND = 4.dp

/** No row is narrower, however large the letters are. */
private const val MIN_COLUMNS = 4
