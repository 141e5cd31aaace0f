package robotran.ui.program

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextLayoutResult
import androidx.compose.ui.unit.dp
import robotran.robolang.SourceRange
import robotran.ui.theme.RobotranColours
import robotran.ui.workshop.offsetOf

/** What lies behind the program text: a band under the line that is running, a wavy line under every mistake. */
internal fun DrawScope.drawProgramMarks(
    layout: TextLayoutResult,
    runningLine: Int,
    mistakes: List<SourceRange>,
    colours: RobotranColours,
) {
    val text = layout.layoutInput.text.text
    val row = runningLine - 1
    if (row in 0 until layout.lineCount) {
        val top = layout.getLineTop(row)
        drawRect(colours.runningLine, Offset(0f, top), Size(size.width, layout.getLineBottom(row) - top))
    }
    for (mistake in mistakes) {
        val start = text.offsetOf(mistake.line, mistake.column) ?: continue
        val end = text.offsetOf(mistake.line, mistake.endColumn) ?: continue
        val from = layout.getHorizontalPosition(start, true)
        val to = layout.getHorizontalPosition(end, true).coerceAtLeast(from + LEAST_WIDTH.toPx())
        drawWave(from, to, layout.getLineBottom(mistake.line - 1) - WAVE.toPx(), colours)
    }
}

private fun DrawScope.drawWave(from: Float, to: Float, middle: Float, colours: RobotranColours) {
    val step = WAVE.toPx()
    val wave = Path().apply {
        moveTo(from, middle)
        var x = from
        var up = true
        while (x < to) {
            x = (x + step).coerceAtMost(to)
            lineTo(x, if (up) middle - step / 2 else middle + step / 2)
            up = !up
        }
    }
    drawPath(wave, colours.mistake, style = Stroke(1.5.dp.toPx()))
}

private val WAVE = 3.dp
private val LEAST_WIDTH = 9.dp
