package robotran.ui.world

import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Fill
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetTransform
import robotran.uikit.*
import robotran.workshop.measuring.Measuring
import robotran.workshop.measuring.MeasuringEnd
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sin

/**
 * Draws ruler and protractor. The ruler lies to the right of the measured way, so that this stays visible, with a tick
 * each centimetre. The protractor shows the turn from its base, with a tick each 10 degrees.
 */
internal fun DrawScope.drawMeasuring(
    measuring: Measuring,
    labels: MeasuringLabels,
    view: SheetTransform,
    text: TextMeasurer,
) {
    val from = view.toPixels(measuring.from)
    val to = view.toPixels(measuring.to)
    val base = view.toPixels(measuring.placeOf(MeasuringEnd.BASE))
    drawRuler(measuring.centimetres, from, to, view)
    drawProtractor(measuring, from, base)
    for (casing in listOf(true, false)) line(from, to, casing)
    handle(base, isSmall = true)
    handle(from, isSmall = false)
    handle(to, isSmall = false)
    if (measuring.centimetres == 0.0) return
    val along = (to - from) / (to - from).getDistance()
    val turn = directionAt(measuring.baseDirection + measuring.degrees / 2)
    plate(labels.angle, from + turn * (protractorRadius() + PLATE_GAP.toPx()), turn, text)
    plate(labels.length, to + along * HANDLE.toPx() + along.toRight() * (RULER.toPx() / 2), along, text)
}

private fun DrawScope.drawRuler(centimetres: Double, from: Offset, to: Offset, view: SheetTransform) {
    val length = (to - from).getDistance()
    if (length == 0f) return
    val along = (to - from) / length
    val across = along.toRight()
    val depth = RULER.toPx()
    val strip = Path().apply {
        moveTo(from.x, from.y)
        lineTo(to.x, to.y)
        (to + across * depth).let { lineTo(it.x, it.y) }
        (from + across * depth).let { lineTo(it.x, it.y) }
        close()
    }
    drawPath(strip, RobotranColours.YELLOW.copy(alpha = RULER_ALPHA), style = Fill)
    drawPath(strip, SheetColours.LABEL, style = Stroke(THIN.toPx()))
    val step = view.toPixels(1.0)
    // Ticks that would touch are left out.
    val every = TICKS.firstOrNull { it * step >= MIN_TICK_DISTANCE.toPx() } ?: return
    var tick = every
    while (tick <= centimetres && tick <= MAX_CENTIMETRES) {
        val place = from + along * (tick * step)
        val deep = when {
            tick % TICKS.last() == 0 -> LONG_TICK
            tick % HALF_TICK == 0 -> MIDDLE_TICK
            else -> SHORT_TICK
        }
        drawLine(SheetColours.LABEL, place, place + across * (depth * deep), THIN.toPx())
        tick += every
    }
}

private fun DrawScope.drawProtractor(measuring: Measuring, middle: Offset, base: Offset) {
    val radius = protractorRadius()
    val sector = arc(measuring, middle, radius)
    sector.lineTo(middle.x, middle.y)
    sector.close()
    drawPath(sector, RobotranColours.CASING.copy(alpha = SECTOR_ALPHA), style = Fill)
    for (casing in listOf(true, false)) {
        dashed(middle, base, casing)
        drawPath(arc(measuring, middle, radius), colour(casing), style = Stroke(width(casing), cap = StrokeCap.Round))
    }
    val side = if (measuring.degrees < 0) -1 else 1
    for (tick in 1..(abs(measuring.degrees) / TICK_DEGREES).toInt()) {
        val way = directionAt(measuring.baseDirection + side * tick * TICK_DEGREES)
        drawLine(SheetColours.LABEL, middle + way * (radius * TICK_START), middle + way * radius, THIN.toPx())
    }
}

/** The turn from the base, in short lines, because an arc of a full turn would be empty. */
private fun arc(measuring: Measuring, middle: Offset, radius: Float) = Path().apply {
    val parts = max(1, ceil(abs(measuring.degrees) / ARC_DEGREES).toInt())
    for (part in 0..parts) {
        val at = middle + directionAt(measuring.baseDirection + measuring.degrees * part / parts) * radius
        if (part == 0) moveTo(at.x, at.y) else lineTo(at.x, at.y)
    }
}

private fun DrawScope.handle(position: Offset, isSmall: Boolean) {
    val radius = (if (isSmall) SMALL_HANDLE else HANDLE).toPx() / 2
    drawCircle(RobotranColours.CASING, radius, position)
    drawCircle(SheetColours.LABEL, radius, position, style = Stroke(LINE.toPx()))
    if (!isSmall) drawCircle(SheetColours.LABEL, LINE.toPx() / 2, position)
}

private fun DrawScope.line(from: Offset, to: Offset, casing: Boolean) =
    drawLine(colour(casing), from, to, width(casing), StrokeCap.Round)

private fun DrawScope.dashed(from: Offset, to: Offset, casing: Boolean) {
    val dash = if (casing) null else PathEffect.dashPathEffect(floatArrayOf(DASH.toPx(), DASH.toPx()))
    drawLine(colour(casing), from, to, width(casing), StrokeCap.Round, dash)
}

private fun colour(casing: Boolean): Color = if (casing) RobotranColours.CASING else SheetColours.LABEL

private fun DrawScope.width(casing: Boolean): Float = (if (casing) CASING else LINE).toPx()

/** Words beyond [position] in the direction [along], inside the picture. */
private fun DrawScope.plate(label: String, position: Offset, along: Offset, text: TextMeasurer) {
    val style = TextStyle(SheetColours.LABEL, fontSize = LABEL_SIZE.sp, fontWeight = FontWeight.Bold)
    val laid = text.measure(label, style, maxLines = 1)
    val pad = 8.dp.toPx()
    val plate = Size(laid.size.width + 2 * pad, laid.size.height + pad)
    val away = max(plate.width * abs(along.x), plate.height * abs(along.y)) / 2 + PLATE_GAP.toPx()
    val middle = position + along * away
    val corner = Offset(
        (middle.x - plate.width / 2).coerceIn(0f, max(0f, size.width - plate.width)),
        (middle.y - plate.height / 2).coerceIn(0f, max(0f, size.height - plate.height)),
    )
    val round = CornerRadius(plate.height / 2)
    drawRoundRect(RobotranColours.CASING, corner, plate, round)
    drawRoundRect(SheetColours.LABEL, corner, plate, round, style = Stroke(THIN.toPx()))
    drawText(laid, topLeft = corner + Offset(pad, pad / 2))
}

private fun DrawScope.protractorRadius(): Float = PROTRACTOR.toPx()

/** The direction to the right of this one on the screen. */
private fun Offset.toRight() = Offset(-y, x)

/** The unit vector of [heading], in degrees counter-clockwise, on the screen. */
private fun directionAt(heading: Double): Offset {
    val radians = heading * PI / HALF_TURN
    return Offset(cos(radians).toFloat(), -sin(radians).toFloat())
}

/** From which distance in centimetres there are ticks, and how far they go into the ruler. */
private val TICKS = listOf(1, 5, 10)
private const val HALF_TICK = 5
private const val LONG_TICK = 0.8f
private const val MIDDLE_TICK = 0.55f
private const val SHORT_TICK = 0.3f

/** The longest way across a sheet is a few metres. */
private const val MAX_CENTIMETRES = 1_000
private const val TICK_DEGREES = 10.0
private const val TICK_START = 0.85f
private const val ARC_DEGREES = 3.0
private const val HALF_TURN = 180.0
private const val RULER_ALPHA = 0.75f
private const val SECTOR_ALPHA = 0.6f
private const val LABEL_SIZE = 16
private val RULER = 22.dp
private val PROTRACTOR = 64.dp
private val HANDLE = 18.dp
private val SMALL_HANDLE = 14.dp
private val PLATE_GAP = 6.dp
private val MIN_TICK_DISTANCE = 4.dp
private val DASH = 6.dp
private val THIN = 1.dp
private val CASING = 5.dp
private val LINE = 2.dp
