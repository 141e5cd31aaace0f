package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.simulation.state.GoalShortfall
import robotran.simulation.state.InkShortfall
import robotran.simulation.state.LineShortfall
import robotran.simulation.state.PlaceShortfall
import robotran.simulation.state.TemplateStretch
import robotran.uikit.*
import robotran.workshop.state.ShortfallMark
import robotran.world.geometry.Point

/** What was missing for the goals, on the sheet from above. */
fun DrawScope.drawShortfalls(marks: List<ShortfallMark>, transform: SheetTransform, labels: TextMeasurer) {
    val toPixels = { place: Point -> transform.toPixels(place.x, place.y) }
    drawShortfallLines(marks, toPixels)
    drawShortfallPins(marks, labels, toPixels)
}

/**
 * What lies flat on the paper: the way that was missing as a dotted line, missing stretches of the template as dashes,
 * and ink beside it under a row of ticks.
 *
 * @param toPixels the pixel of a place on the paper; null if it is behind the camera.
 */
fun DrawScope.drawShortfallLines(marks: List<ShortfallMark>, toPixels: (Point) -> Offset?) {
    for (mark in marks) {
        when (val shortfall = mark.shortfall) {
            is InkShortfall.TemplateMissing -> shortfall.missing.forEach { drawMissing(it, toPixels) }
            is InkShortfall.InkBesideTemplate -> shortfall.beside.forEach { drawBeside(it, toPixels) }
            else -> missingWay(shortfall)?.let { (from, to) -> drawWay(from, to, toPixels) }
        }
    }
}

/** A pin with its letter at each place. */
fun DrawScope.drawShortfallPins(marks: List<ShortfallMark>, labels: TextMeasurer, toPixels: (Point) -> Offset?) {
    for (mark in marks) {
        val place = mark.shortfall.place ?: continue
        toPixels(place)?.let { drawPin(mark.sign.orEmpty(), it, labels) }
    }
}

private fun missingWay(shortfall: GoalShortfall): Pair<Point, Point>? = when (shortfall) {
    is PlaceShortfall.NotReached -> shortfall.place?.let { it to shortfall.target }
    is LineShortfall.NotReached -> shortfall.place?.let { it to shortfall.target }
    else -> null
}

private fun DrawScope.drawWay(from: Point, to: Point, toPixels: (Point) -> Offset?) {
    val width = WIDTH.toPx()
    drawLine(
        SheetColours.SHORTFALL,
        toPixels(from) ?: return,
        toPixels(to) ?: return,
        width,
        StrokeCap.Round,
        // Dashes of zero length with round ends are dots.
        PathEffect.dashPathEffect(floatArrayOf(0f, 2 * width)),
    )
}

private fun DrawScope.drawMissing(stretch: TemplateStretch, toPixels: (Point) -> Offset?) {
    val width = WIDTH.toPx()
    val dashes = PathEffect.dashPathEffect(floatArrayOf(DASH * width, DASH * width))
    drawPath(
        pathOf(stretch, toPixels),
        SheetColours.SHORTFALL,
        style = Stroke(width, cap = StrokeCap.Butt, join = StrokeJoin.Round, pathEffect = dashes),
    )
}

/** Ticks across the line, so that it does not only differ by its colour. */
private fun DrawScope.drawBeside(stretch: TemplateStretch, toPixels: (Point) -> Offset?) {
    val path = pathOf(stretch, toPixels)
    val tick = TICK.toPx()
    drawPath(path, SheetColours.SHORTFALL.copy(alpha = BAND_ALPHA), style = Stroke(tick, cap = StrokeCap.Round))
    val ticks = PathEffect.dashPathEffect(floatArrayOf(tick / 5, tick * 0.8f))
    drawPath(path, SheetColours.SHORTFALL, style = Stroke(tick, pathEffect = ticks))
}

/** Interrupted where it goes behind the camera. */
private fun pathOf(stretch: TemplateStretch, toPixels: (Point) -> Offset?) = Path().apply {
    var isSeen = false
    for (point in stretch.points) {
        val pixel = toPixels(point)
        if (pixel != null && isSeen) lineTo(pixel.x, pixel.y)
        if (pixel != null && !isSeen) moveTo(pixel.x, pixel.y)
        isSeen = pixel != null
    }
}

/** A drop with its tip at [tip]. */
private fun DrawScope.drawPin(letter: String, tip: Offset, labels: TextMeasurer) {
    val radius = PIN_RADIUS.toPx()
    // At the upper edge the pin hangs upside down, so that its letter stays visible.
    val up = if (tip.y < PIN_HEIGHT * radius) -1f else 1f
    val middle = tip - Offset(0f, up * (PIN_HEIGHT - 1) * radius)
    val drop = Path().apply {
        moveTo(tip.x, tip.y)
        lineTo(middle.x - radius * 0.85f, middle.y + up * radius * 0.55f)
        lineTo(middle.x + radius * 0.85f, middle.y + up * radius * 0.55f)
        close()
    }
    val edge = Stroke(2.dp.toPx(), join = StrokeJoin.Round)
    drawPath(drop, RobotranColours.CASING, style = edge)
    drawCircle(RobotranColours.CASING, radius + 1.dp.toPx(), middle)
    drawPath(drop, SheetColours.SHORTFALL)
    drawCircle(SheetColours.SHORTFALL, radius, middle)
    drawLabel(labels, letter, middle, radius * 1.2f, RobotranColours.CASING)
}

private val WIDTH = 4.dp
private val TICK = 10.dp
private val PIN_RADIUS = 12.dp

/** From tip to top, in radii. */
private const val PIN_HEIGHT = 2.7f
private const val DASH = 2f
private const val BAND_ALPHA = 0.2f
