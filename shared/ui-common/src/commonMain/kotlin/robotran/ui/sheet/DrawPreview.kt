package robotran.ui.sheet

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.world.geometry.Pose
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sign
import kotlin.math.sin

/**
 * Draws what an edited number would do: for a length a ruler with a tick each 10 cm, for an angle an arc to the
 * direction after the turn. A light casing below the dark strokes gives contrast on any paper, ink and mark.
 *
 * @param isSmall whether it is for a small picture, in which nothing can be dragged.
 */
fun DrawScope.drawPreview(
    preview: SheetPreview,
    view: SheetTransform,
    labels: TextMeasurer,
    isSmall: Boolean = false,
) {
    val pen = PreviewPen(if (isSmall) SMALL else 1f, labels)
    val end = previewEnd(preview, view)
    when (preview) {
        is SheetPreview.Way -> {
            drawWay(preview, view, end, pen, isSmall)
            drawPlate("${preview.text} cm", end, directionOf(preview.pose, preview.centimetres), pen)
        }

        is SheetPreview.Turn -> {
            drawTurn(preview, view, end, pen)
            drawPlate("${preview.text}°", end, directionAt(preview.pose.heading + preview.degrees), pen)
        }
    }
}

/** @property scale that of strokes; letters shrink less, to stay legible. */
private class PreviewPen(val scale: Float, val labels: TextMeasurer) {
    val labelScale: Float get() = (1 + scale) / 2
}

/** Where the drawing of [preview] ends, in pixels: there it can be dragged. */
fun previewEnd(preview: SheetPreview, view: SheetTransform): Offset {
    val pose = preview.pose
    return when (preview) {
        is SheetPreview.Way -> {
            view.toPixels(pose.x, pose.y) + directionAt(pose.heading) * view.toPixels(preview.centimetres)
        }

        is SheetPreview.Turn -> {
            view.toPixels(pose.x, pose.y) +
                directionAt(pose.heading + preview.degrees) * view.toPixels(RADIUS_CENTIMETRES)
        }
    }
}

private fun DrawScope.drawWay(
    way: SheetPreview.Way,
    view: SheetTransform,
    end: Offset,
    pen: PreviewPen,
    hasArrow: Boolean,
) {
    val start = view.toPixels(way.pose.x, way.pose.y)
    val along = directionOf(way.pose, way.centimetres)
    val across = Offset(-along.y, along.x) * (TICK.toPx() * pen.scale)
    val ticks = (1..(abs(way.centimetres) / TICK_CENTIMETRES).toInt().coerceAtMost(MAX_TICKS)).map {
        start + along * view.toPixels(it * TICK_CENTIMETRES)
    }
    for (casing in listOf(true, false)) {
        dashed(start, end, casing, pen)
        for (tick in ticks) solid(tick - across, tick + across, casing, pen)
        solid(start - across, start + across, casing, pen)
        if (hasArrow) arrow(end, along, casing, pen)
    }
}

private fun DrawScope.drawTurn(turn: SheetPreview.Turn, view: SheetTransform, end: Offset, pen: PreviewPen) {
    val middle = view.toPixels(turn.pose.x, turn.pose.y)
    val radius = view.toPixels(RADIUS_CENTIMETRES)
    val before = middle + directionAt(turn.pose.heading) * radius
    val arcRadius = radius * ARC
    val sweep = turn.degrees.coerceIn(-FULL, FULL)
    val arc = Path().apply {
        // An arc of a full turn would be empty, so it is drawn in short lines.
        val parts = max(1, (abs(sweep) / ARC_STEP).toInt())
        for (part in 0..parts) {
            val at = middle + directionAt(turn.pose.heading + sweep * part / parts) * arcRadius
            if (part == 0) moveTo(at.x, at.y) else lineTo(at.x, at.y)
        }
    }
    val after = directionAt(turn.pose.heading + turn.degrees)
    for (casing in listOf(true, false)) {
        dashed(middle, before, casing, pen)
        solid(middle, end, casing, pen)
        drawPath(
            arc,
            strokeColour(casing),
            style = Stroke(strokeWidth(casing, pen), cap = StrokeCap.Round, join = StrokeJoin.Round),
        )
        if (turn.degrees != 0.0) arrow(middle + after * arcRadius, after.turned(sign(turn.degrees)), casing, pen)
    }
}

/** The direction across this one, to its left on the sheet for 1, to its right for -1. */
private fun Offset.turned(side: Double) = Offset(y, -x) * side.toFloat()

private fun DrawScope.arrow(tip: Offset, along: Offset, casing: Boolean, pen: PreviewPen) {
    val across = Offset(-along.y, along.x)
    val length = ARROW.toPx() * pen.scale
    for (side in listOf(-1f, 1f)) {
        solid(tip, tip - along * length + across * (length * side * LEAN), casing, pen)
    }
}

private fun DrawScope.dashed(from: Offset, to: Offset, casing: Boolean, pen: PreviewPen) {
    val length = DASH.toPx() * pen.scale
    val dash = if (casing) null else PathEffect.dashPathEffect(floatArrayOf(length, length))
    drawLine(strokeColour(casing), from, to, strokeWidth(casing, pen), StrokeCap.Round, dash)
}

private fun DrawScope.solid(from: Offset, to: Offset, casing: Boolean, pen: PreviewPen) =
    drawLine(strokeColour(casing), from, to, strokeWidth(casing, pen), StrokeCap.Round)

private fun strokeColour(casing: Boolean): Color = if (casing) RobotranColours.CASING else SheetColours.LABEL

private fun DrawScope.strokeWidth(casing: Boolean, pen: PreviewPen): Float =
    (if (casing) CASING else LINE).toPx() * pen.scale

/** The number beyond [end], inside the picture. */
private fun DrawScope.drawPlate(label: String, end: Offset, along: Offset, pen: PreviewPen) {
    val text = pen.labels.measure(
        label,
        TextStyle(SheetColours.LABEL, fontSize = (LABEL_SIZE * pen.labelScale).sp, fontWeight = FontWeight.Bold),
    )
    val pad = 8.dp.toPx() * pen.scale
    val plate = Size(text.size.width + 2 * pad, text.size.height + pad)
    val away = PLATE_DISTANCE.toPx() * pen.scale + max(plate.width * abs(along.x), plate.height * abs(along.y)) / 2
    val middle = end + along * away
    val corner = Offset(
        (middle.x - plate.width / 2).coerceIn(0f, max(0f, size.width - plate.width)),
        (middle.y - plate.height / 2).coerceIn(0f, max(0f, size.height - plate.height)),
    )
    val round = CornerRadius(plate.height / 2)
    drawRoundRect(RobotranColours.CASING, corner, plate, round)
    drawRoundRect(SheetColours.LABEL, corner, plate, round, style = Stroke(LINE.toPx() / 2))
    drawText(text, topLeft = corner + Offset(pad, pad / 2))
}

/** The direction in which a robot at [pose] drives [centimetres], on the screen. */
private fun directionOf(pose: Pose, centimetres: Double): Offset =
    directionAt(if (centimetres < 0) pose.heading + FULL / 2 else pose.heading)

/** The unit vector of [heading], in degrees counter-clockwise, on the screen. */
private fun directionAt(heading: Double): Offset {
    val radians = heading * PI / (FULL / 2)
    return Offset(cos(radians).toFloat(), -sin(radians).toFloat())
}

/** How far the direction of a turn is drawn: well beyond the robot. */
private const val RADIUS_CENTIMETRES = 20.0
private const val TICK_CENTIMETRES = 10.0

/** The sheet is about a metre wide; a mistyped number shall not draw for long. */
private const val MAX_TICKS = 100
private const val FULL = 360.0
private const val ARC = 0.7f
private const val ARC_STEP = 3.0
private const val SMALL = 0.5f
private const val LEAN = 0.6f
private const val LABEL_SIZE = 18
private val TICK = 6.dp
private val ARROW = 12.dp
private val DASH = 8.dp
private val CASING = 7.dp
private val LINE = 3.dp

/** From the end to the number; the handle for fingers lies between. */
private val PLATE_DISTANCE = 20.dp
