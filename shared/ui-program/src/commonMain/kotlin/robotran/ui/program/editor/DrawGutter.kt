package robotran.ui.program.editor

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.unit.dp
import robotran.ui.code.CodeColours
import robotran.uikit.*

/** The layouts of the line numbers, cached. */
internal class NumberLayouts(private val measurer: TextMeasurer, private val style: TextStyle) {
    private val kept = HashMap<String, TextLayoutResult>()

    fun of(text: String): TextLayoutResult {
        if (kept.size > MAX_CACHED) kept.clear()
        return kept.getOrPut(text) { measurer.measure(text, style) }
    }

    private companion object {
        const val MAX_CACHED = 400
    }
}

/**
 * Draws the numbers of the visible lines, with a sign for errors, failures, warnings, the running line and breakpoints.
 */
internal class GutterDrawing(
    private val marks: EditorMarks,
    private val view: EditorView,
    private val numbers: NumberLayouts,
    private val colours: RobotranColours,
    private val code: CodeColours,
) {
    private val mistaken = marks.diagnostics.mapTo(mutableSetOf(marks.failedLine)) { it.line }
    private val warningLines = marks.warnings.mapTo(mutableSetOf()) { it.line }

    fun DrawScope.draw(lines: Int) {
        val visible = view.visibleLines
        for (line in visible.first..minOf(visible.last, lines - 1)) {
            drawNumber(
                line + 1,
                view.geometry.top(line) - view.scrollY,
            )
        }
    }

    private fun DrawScope.drawNumber(line: Int, top: Float) {
        val height = view.geometry.lineHeight
        val right = view.gutter - GAP.toPx()
        val hasStop = line in marks.breakpoints
        if (hasStop) {
            val shape = Size(right, height - 2.dp.toPx())
            drawRoundRect(code.breakpoint, Offset(4.dp.toPx(), top + 1.dp.toPx()), shape, CornerRadius(height / 2))
        }
        val sign = when {
            line in mistaken -> "!"
            line in warningLines -> "?"
            else -> ""
        }
        val colour = when {
            hasStop -> RobotranColours.ON_COLOUR
            line in mistaken -> colours.error
            line in warningLines -> code.warning
            line == marks.runningLine -> colours.onPane
            else -> colours.quiet
        }
        val number = numbers.of(line.toString())
        drawText(number, colour, Offset(right - number.size.width, top + (height - number.size.height) / 2))
        if (line == marks.runningLine) {
            drawArrow(top, height, if (hasStop) RobotranColours.ON_COLOUR else colours.onPane)
        } else if (sign.isNotEmpty()) {
            drawText(numbers.of(sign), colour, Offset(10.dp.toPx(), top + (height - number.size.height) / 2))
        }
    }

    private fun DrawScope.drawArrow(top: Float, height: Float, colour: Color) {
        val half = minOf(height / 3, 6.dp.toPx())
        val left = 9.dp.toPx()
        val middle = top + height / 2
        drawPath(
            Path().apply {
                moveTo(left, middle - half)
                lineTo(left + half * 1.4f, middle)
                lineTo(left, middle + half)
                close()
            },
            colour,
        )
    }
}

/** Between the numbers and the text. */
internal val GAP = 10.dp
