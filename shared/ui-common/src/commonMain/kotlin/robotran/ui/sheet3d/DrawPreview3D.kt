package robotran.ui.sheet3d

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.unit.dp
import robotran.scene3d.camera.Projection
import robotran.scene3d.geometry.Vector3
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.addLine
import robotran.ui.sheet.drawReading
import robotran.ui.sheet.towards
import robotran.uikit.*
import robotran.workshop.blocks.SheetPreview
import robotran.world.geometry.Point
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.ceil

/** Draws on the paper what an edited number would do, see [robotran.ui.sheet.drawPreview]. */
fun DrawScope.drawPreview3D(preview: SheetPreview, projection: Projection, labels: TextMeasurer) {
    val lines = when (preview) {
        is SheetPreview.Way -> wayLines(preview)
        is SheetPreview.Turn -> turnLines(preview)
    }
    for (isCasing in listOf(true, false)) {
        val width = (if (isCasing) CASING else LINE).toPx()
        val stroke = Stroke(width, cap = StrokeCap.Round, join = StrokeJoin.Round)
        for (line in lines) {
            // What is behind the camera is left out.
            val pixels = line.mapNotNull { projection.pixel(it) }
            if (pixels.size < 2) continue
            drawPath(
                Path().apply {
                    addLine(pixels)
                },
                if (isCasing) RobotranColours.CASING else SheetColours.LABEL,
                style = stroke,
            )
        }
    }
    val end = previewEnd3D(preview, projection) ?: return
    val words = when (preview) {
        is SheetPreview.Way -> "${preview.text} cm"
        is SheetPreview.Turn -> "${preview.text}°"
    }
    drawReading(words, end - Offset(0f, PLATE_DISTANCE.toPx()), labels, SheetColours.LABEL)
}

/** Where the drawing of [preview] ends, in pixels; null if it is behind the camera. */
fun previewEnd3D(preview: SheetPreview, projection: Projection): Offset? {
    val pen = Point(preview.pose.x, preview.pose.y)
    val heading = preview.pose.heading * RADIANS_PER_DEGREE
    return projection.pixel(
        when (preview) {
            is SheetPreview.Way -> pen.towards(heading, preview.centimetres)
            is SheetPreview.Turn -> pen.towards(heading + preview.degrees * RADIANS_PER_DEGREE, RADIUS)
        },
    )
}

/** The way with a tick each ten centimetres. */
private fun wayLines(way: SheetPreview.Way): List<List<Point>> {
    val pen = Point(way.pose.x, way.pose.y)
    val heading = way.pose.heading * RADIANS_PER_DEGREE
    val sign = if (way.centimetres < 0) -1 else 1
    val ticks = (0..(abs(way.centimetres) / TICK_STEP).toInt().coerceAtMost(MAX_TICKS)).map {
        val at = pen.towards(heading, sign * it * TICK_STEP)
        listOf(at.towards(heading + PI / 2, TICK), at.towards(heading - PI / 2, TICK))
    }
    return ticks + listOf(listOf(pen, pen.towards(heading, way.centimetres)))
}

private fun turnLines(turn: SheetPreview.Turn): List<List<Point>> {
    val pen = Point(turn.pose.x, turn.pose.y)
    val heading = turn.pose.heading * RADIANS_PER_DEGREE
    val sweep = turn.degrees.coerceIn(-FULL_TURN, FULL_TURN) * RADIANS_PER_DEGREE
    val parts = ceil(abs(sweep) / ARC_STEP).toInt().coerceAtLeast(1)
    val arc = (0..parts).map { pen.towards(heading + sweep * it / parts, RADIUS * ARC) }
    return listOf(
        listOf(pen, pen.towards(heading, RADIUS)),
        listOf(pen, pen.towards(heading + turn.degrees * RADIANS_PER_DEGREE, RADIUS)),
        arc,
    )
}

private fun Projection.pixel(point: Point): Offset? = toScreen(Vector3(point.x, point.y, 0.0))?.toOffset()

/** In centimetres. */
private const val RADIUS = 20.0
private const val TICK_STEP = 10.0
private const val TICK = 1.0
private const val MAX_TICKS = 100
private const val FULL_TURN = 360.0
private const val ARC = 0.7

/** In radians. */
private const val ARC_STEP = 0.06
private val CASING = 7.dp
private val LINE = 3.dp
private val PLATE_DISTANCE = 34.dp
