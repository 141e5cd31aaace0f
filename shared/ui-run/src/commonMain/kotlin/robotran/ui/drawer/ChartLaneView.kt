package robotran.ui.drawer

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.style.TextAlign
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.brick.controls.PowerUnit
import robotran.brick.kind.BrickKind
import robotran.runcontrol.ChartLine
import robotran.ui.run.tags.RunTags
import robotran.ui.texts.NxtTexts
import robotran.uikit.*

/**
 * One lane of the chart with its [name] and its value at the time [at].
 *
 * @param now the current time of the run.
 * @param onTouch receives the touched time; null on release.
 */
@Composable
internal fun Lane(
    name: String,
    line: ChartLine,
    brick: BrickKind,
    window: ChartWindow,
    at: Long,
    now: Long,
    onTouch: (Long?) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val value = valueText(line, brick, at)
    val spoken = value ?: NxtTexts.runChartNoValue(spoken)
    val unit = line.unit.sign
    val latest by rememberUpdatedState(window)
    val touch by rememberUpdatedState(onTouch)
    Row(
        Modifier.fillMaxWidth().padding(vertical = 2.dp).semantics(mergeDescendants = true) {
            contentDescription = if (value == null) "$name: $spoken" else "$name: $value $unit".trimEnd()
        },
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        Column(Modifier.width(76.dp * LocalDensity.current.fontScale)) {
            val title = if (unit.isEmpty()) name else "$name\n$unit"
            Text(title, style = TextStyles.caption, color = colours.quiet)
        }
        Canvas(
            Modifier
                .testTag(RunTags.chart(line.lane))
                .weight(1f)
                .height(LANE_HEIGHT)
                .pointerInput(Unit) {
                    awaitEachGesture {
                        val down = awaitFirstDown()
                        touch(latest.timeAt(down.position.x / size.width))
                        do {
                            val event = awaitPointerEvent()
                            val change = event.changes.firstOrNull { it.id == down.id } ?: break
                            // Vertical drags scroll the lanes, horizontal drags read values.
                            if (change.pressed && !change.isConsumed) {
                                touch(latest.timeAt(change.position.x / size.width))
                            }
                        } while (change.pressed)
                        touch(null)
                    }
                },
        ) { drawLane(line, rangeOf(line, brick), window, at, now, colours) }
        Text(
            value ?: NO_VALUE,
            Modifier.widthIn(min = valueWidth(brick)).testTag(RunTags.value(line.lane)),
            TextStyles.compact.strong,
            textAlign = TextAlign.End,
            maxLines = 1,
        )
    }
}

/** The value of [line] at [time]; a range if it changed too fast for the chart, null if nothing was measured. */
private fun valueText(line: ChartLine, brick: BrickKind, time: Long): String? {
    if (line.size == 0) return ""
    val values = line.range(line.pieceAt(time)) ?: return null
    val first = signed(line, brick, values.first)
    return if (values.first == values.last) first else "$first–${signed(line, brick, values.last)}"
}

/**
 * For a motor, the power from 0 to 7 as programs, the ROM and the ports of an RCX count it, or in percent as those of an
 * NXT do, with the direction as sign; 0 without sign if it is not driven.
 */
private fun signed(line: ChartLine, brick: BrickKind, value: Int) = when {
    !line.lane.isMotor || value == 0 -> "$value"
    brick.powerUnit == PowerUnit.PERCENT -> if (value > 0) "+$value" else "$value"
    value > 0 -> "+${value - 1}"
    else -> "-${-value - 1}"
}

private fun DrawScope.drawLane(
    line: ChartLine,
    range: IntRange,
    window: ChartWindow,
    at: Long,
    now: Long,
    colours: RobotranColours,
) {
    fun y(value: Int) = size.height - PAD.toPx() -
        (size.height - 2 * PAD.toPx()) * (value.coerceIn(range) - range.first) /
        (range.last - range.first).coerceAtLeast(1)
    drawRect(colours.line.copy(alpha = 0.25f), Offset.Zero, Size(size.width, size.height))
    if (0 in range) drawLine(colours.line, Offset(0f, y(0)), Offset(size.width, y(0)), 1.dp.toPx())
    drawValues(line, window, colours.onPane, ::y)
    val x = window.shareOf(now) * size.width
    val dashes = PathEffect.dashPathEffect(floatArrayOf(6f, 4f))
    drawLine(colours.focus, Offset(x, 0f), Offset(x, size.height), 1.5.dp.toPx(), pathEffect = dashes)
    if (at != now) {
        val touched = window.shareOf(at) * size.width
        drawLine(colours.onPane, Offset(touched, 0f), Offset(touched, size.height), 1.5.dp.toPx())
    }
}

/**
 * A step line through the values with at most one corner per pixel. It has gaps where nothing was measured.
 */
private fun DrawScope.drawValues(line: ChartLine, window: ChartWindow, colour: Color, y: (Int) -> Float) {
    if (line.size == 0) return
    val first = line.pieceAt(window.from)
    val last = line.pieceAt(window.until)
    val pixels = size.width.toInt().coerceAtLeast(1)
    val stride = ((last - first) / pixels).coerceAtLeast(1)
    val path = Path()
    var before = Float.NaN
    for (piece in first..last step stride) {
        val values = valuesOf(line, piece..minOf(piece + stride - 1, last))
        if (values == null) {
            before = Float.NaN
            continue
        }
        val x = window.shareOf(piece * line.step) * size.width
        val next = (window.shareOf((piece + stride) * line.step) * size.width).coerceAtMost(size.width)
        val isFromTop = !before.isNaN() && before <= y(values.last)
        val enter = if (isFromTop) y(values.last) else y(values.first)
        val leave = if (isFromTop) y(values.first) else y(values.last)
        if (before.isNaN()) path.moveTo(x, enter) else path.lineTo(x, enter)
        path.lineTo(x, leave)
        path.lineTo(next, leave)
        before = leave
    }
    drawPath(path, colour, style = Stroke(1.5.dp.toPx()))
}

/** All values of [line] in these [pieces]; null if nothing was measured. */
private fun valuesOf(line: ChartLine, pieces: IntRange): IntRange? {
    var all: IntRange? = null
    for (piece in pieces) {
        val values = line.range(piece) ?: continue
        all = minOf(all?.first ?: values.first, values.first)..maxOf(all?.last ?: values.last, values.last)
    }
    return all
}

/** Room for a value, so that the lanes end at the same place: "+7" in steps, "-100–+100" in percent. */
private fun valueWidth(brick: BrickKind): Dp = when (brick.powerUnit) {
    PowerUnit.STEPS -> 48.dp
    PowerUnit.PERCENT -> 76.dp
}

/** In the place of a value that nobody has measured. */
private const val NO_VALUE = "–"
private val LANE_HEIGHT = 44.dp
private val PAD = 4.dp
