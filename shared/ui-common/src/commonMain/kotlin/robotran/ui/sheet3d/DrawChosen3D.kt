package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.dp
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.uikit.*
import robotran.world.geometry.Point

/** A ring on the paper around the selected element at [middle]. */
fun DrawScope.drawChosenRing(middle: Point, radius: Double, colour: Color, projection: Projection) {
    val ring = groundPath(circle(middle, radius), projection)
    drawPath(ring, RobotranColours.CASING, style = Stroke(CASING.toPx(), join = StrokeJoin.Round))
    drawPath(ring, colour, style = Stroke(LINE.toPx(), join = StrokeJoin.Round))
}

/** The line from that ring to the handle for turning. Returns the handle's place and its direction; null if unseen. */
fun DrawScope.drawHandleLine(
    middle: Point,
    handle: Point,
    radius: Double,
    colour: Color,
    projection: Projection,
): Pair<Offset, Offset>? {
    fun pixel(point: Point) = projection.toScreen(Vector3(point.x, point.y, 0.0))?.toOffset()
    val length = robotran.ui.sheet.distance(middle, handle)
    if (length == 0.0) return null
    val share = radius / length
    val edge = Point(middle.x + (handle.x - middle.x) * share, middle.y + (handle.y - middle.y) * share)
    val from = pixel(edge) ?: return null
    val to = pixel(handle) ?: return null
    drawLine(RobotranColours.CASING, from, to, CASING.toPx(), StrokeCap.Round)
    drawLine(colour, from, to, LINE.toPx(), StrokeCap.Round)
    return to to (to - from) / (to - from).getDistance().coerceAtLeast(1f)
}

private val CASING = 5.dp
private val LINE = 2.dp
