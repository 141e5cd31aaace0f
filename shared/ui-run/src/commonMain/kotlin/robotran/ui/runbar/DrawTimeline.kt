package robotran.ui.runbar

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.unit.dp
import robotran.runcontrol.CallCountLine
import robotran.runcontrol.MarkKind
import robotran.runcontrol.TimelineMark
import robotran.uikit.*
import robotran.workshop.state.RunPaneState
import kotlin.math.roundToLong

/** Maps times to x positions on a timeline, in pixels from its left. */
internal class TimelinePlan {
    /** Whether the user is dragging on it. */
    var isDragged = false

    /** The margin at both ends in pixels, so that the handle is not cut off. */
    var margin = 0f
        private set

    /** The touch radius of a mark in pixels. */
    val grip: Float get() = margin * 0.8f

    fun fit(scope: DrawScope) {
        margin = with(scope) { MARGIN.toPx() }
    }

    fun placeOf(time: Long, width: Float, length: Long): Float =
        margin + (width - 2 * margin) * (if (length <= 0) 0f else time.toFloat() / length).coerceIn(0f, 1f)

    fun timeAt(x: Float, width: Float, length: Long): Long =
        (((x - margin) / (width - 2 * margin)).coerceIn(0f, 1f).toDouble() * length).roundToLong()

    private companion object {
        val MARGIN = 12.dp
    }
}

internal fun DrawScope.drawTimeline(state: RunPaneState, plan: TimelinePlan, colours: RobotranColours) {
    plan.fit(this)
    val middle = size.height * LINE_SHARE
    val handle = plan.placeOf(state.time, size.width, state.length)
    drawLine(
        colours.line,
        Offset(plan.margin, middle),
        Offset(size.width - plan.margin, middle),
        4.dp.toPx(),
        StrokeCap.Round,
    )
    if (state.untouched) return
    drawLine(colours.onPane, Offset(plan.margin, middle), Offset(handle, middle), 4.dp.toPx(), StrokeCap.Round)
    state.calls?.let { drawCalls(it, state.length, plan, middle, colours) }
    var last = Float.NEGATIVE_INFINITY
    for (mark in state.marks) {
        val x = plan.placeOf(mark.milliseconds, size.width, state.length)
        // Of overlapping marks only the first is drawn, except for rare kinds.
        if (mark.kind.isRare || x - last >= 3.dp.toPx()) drawMark(mark, Offset(x, middle - 12.dp.toPx()), colours)
        last = x
    }
    drawRoundRect(
        colours.pane,
        Offset(handle - 5.dp.toPx(), middle - 12.dp.toPx()),
        Size(10.dp.toPx(), 24.dp.toPx()),
        CornerRadius(5.dp.toPx()),
    )
    drawRoundRect(
        colours.onPane,
        Offset(handle - 3.dp.toPx(), middle - 10.dp.toPx()),
        Size(6.dp.toPx(), 20.dp.toPx()),
        CornerRadius(3.dp.toPx()),
    )
}

/** Below the line, a bar chart of the ROM calls, one bar per few pixels. */
private fun DrawScope.drawCalls(
    calls: CallCountLine,
    length: Long,
    plan: TimelinePlan,
    middle: Float,
    colours: RobotranColours,
) {
    val width = 2.dp.toPx()
    val top = middle + 4.dp.toPx()
    var x = plan.margin
    var from = -1L
    while (x < size.width - plan.margin && length > 0) {
        val until = plan.timeAt(x + width, size.width, length)
        val count = calls.between(from, until)
        if (count > 0) {
            // Logarithmic: a loop that reads a sensor must not hide the few calls that start a motor.
            val long = minOf(CALL_UNITS, 2 + (Int.SIZE_BITS - count.countLeadingZeroBits()) / 2).dp.toPx()
            drawRect(colours.quiet, Offset(x, top), Size(width, long))
        }
        from = until
        x += width
    }
}

/** Each kind has its own shape in addition to its colour. */
private fun DrawScope.drawMark(mark: TimelineMark, position: Offset, colours: RobotranColours) {
    val unit = 5.dp.toPx()
    when (mark.kind) {
        MarkKind.START -> drawPath(shape(position, unit, -0.6f, -1f, 1f, 0f, -0.6f, 1f), RobotranColours.RUN_GREEN)

        MarkKind.END -> drawRect(
            colours.quiet,
            position - Offset(unit * 0.7f, unit * 0.7f),
            Size(unit * 1.4f, unit * 1.4f),
        )

        MarkKind.FAILURE -> drawCross(position, unit, colours.error)
        MarkKind.GOAL -> drawPath(star(position, unit * 1.5f), colours.onPane)
        MarkKind.GOAL_LOST -> drawCross(position, unit * 0.8f, colours.quiet)
        MarkKind.WARNING -> drawPath(shape(position, unit, 0f, -1f, 1f, 0f, 0f, 1f, -1f, 0f), colours.focus)
        MarkKind.BUMP -> drawPath(shape(position, unit, -1f, 1f, 0f, -1f, 1f, 1f), colours.error)
        MarkKind.BEEP -> drawCircle(colours.quiet, unit * 0.6f, position)
        MarkKind.MESSAGE -> drawRect(colours.focus, position - Offset(unit * 0.3f, unit), Size(unit * 0.6f, unit * 2))
    }
}

private fun DrawScope.drawCross(position: Offset, half: Float, colour: Color) {
    val width = 2.5.dp.toPx()
    drawLine(colour, position - Offset(half, half), position + Offset(half, half), width, StrokeCap.Round)
    drawLine(colour, position + Offset(-half, half), position + Offset(half, -half), width, StrokeCap.Round)
}

private fun shape(position: Offset, unit: Float, vararg corners: Float): Path = Path().apply {
    moveTo(position.x + corners[0] * unit, position.y + corners[1] * unit)
    for (corner in 2..<corners.size step 2) {
        lineTo(
            position.x + corners[corner] * unit,
            position.y + corners[corner + 1] * unit,
        )
    }
    close()
}

private fun star(position: Offset, unit: Float): Path = shape(
    position,
    unit,
    0f,
    -1f,
    0.24f,
    -0.32f,
    0.95f,
    -0.31f,
    0.38f,
    0.12f,
    0.59f,
    0.81f,
    0f,
    0.4f,
    -0.59f,
    0.81f,
    -0.38f,
    0.12f,
    -0.95f,
    -0.31f,
    -0.24f,
    -0.32f,
)

/** The max length of the ROM call bars. */
private const val CALL_UNITS = 8

/** The vertical position of the line; marks are above it, ROM calls below. */
private const val LINE_SHARE = 0.66f
