package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Canvas
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.FilterQuality
import androidx.compose.ui.graphics.ImageBitmap
import androidx.compose.ui.graphics.Paint
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PointMode
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.IntOffset
import androidx.compose.ui.unit.IntSize
import robotran.uikit.*
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Shade
import robotran.world.geometry.Shape
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.max
import kotlin.math.roundToInt

/** A mark prepared for drawing, in pixels. */
sealed interface MarkDrawing {
    /**
     * An area, or a line of a [width].
     *
     * @property dots the centres of the dots that mark blue for colour-blind pupils; empty for other colours.
     */
    class Painted(val path: Path, val colour: Color, val width: Float?, val dots: List<Offset>, val dotSize: Float) :
        MarkDrawing

    /** A picture with one pixel per cell. */
    class Picture(val image: ImageBitmap, val place: Rect) : MarkDrawing
}

fun markDrawing(mark: Mark, transform: SheetTransform): MarkDrawing = when (val figure = mark.figure) {
    is MarkFigure.Area -> area(figure.shape, mark.shade, transform)
    is MarkFigure.Line -> line(figure, mark.shade, transform)
    is MarkFigure.GreyMap -> picture(figure, transform)
}

internal fun DrawScope.drawMark(mark: MarkDrawing) {
    when (mark) {
        is MarkDrawing.Painted -> drawPainted(mark)

        is MarkDrawing.Picture -> drawImage(
            mark.image,
            dstOffset = IntOffset(mark.place.left.roundToInt(), mark.place.top.roundToInt()),
            dstSize = IntSize(mark.place.width.roundToInt(), mark.place.height.roundToInt()),
            filterQuality = FilterQuality.None,
        )
    }
}

private fun DrawScope.drawPainted(mark: MarkDrawing.Painted) {
    if (mark.width != null) {
        drawPath(mark.path, mark.colour, style = Stroke(mark.width, cap = StrokeCap.Round, join = StrokeJoin.Round))
    } else {
        drawPath(mark.path, mark.colour)
    }
    if (mark.dots.isNotEmpty()) {
        drawPoints(
            mark.dots,
            PointMode.Points,
            SheetColours.MARK_DOTS,
            mark.dotSize,
            StrokeCap.Round,
        )
    }
}

private fun area(shape: Shape, shade: Shade, transform: SheetTransform): MarkDrawing {
    val step = dotStep(transform)
    val dots = if (shade.isBlue) {
        dotsWithin(
            shape.corners().map {
                transform.toPixels(it.x, it.y)
            },
            step,
        )
    } else {
        emptyList()
    }
    return MarkDrawing.Painted(pathOf(shape, transform), shade.colour, null, dots, step * DOT_PART)
}

private fun line(line: MarkFigure.Line, shade: Shade, transform: SheetTransform): MarkDrawing {
    val points = line.points.map { transform.toPixels(it.x, it.y) }
    val width = (line.width * transform.pixelsPerCentimetre).toFloat()
    val step = dotStep(transform)
    val dots = if (shade.isBlue) {
        placesAlong(
            if (line.closed) points + points.first() else points,
            step,
        )
    } else {
        emptyList()
    }
    val path = Path().apply { addLine(points, line.closed) }
    return MarkDrawing.Painted(path, shade.colour, width, dots, minOf(step * DOT_PART, width / 2))
}

private fun picture(map: MarkFigure.GreyMap, transform: SheetTransform): MarkDrawing {
    val columns = map.rows.first().length
    val image = ImageBitmap(columns, map.rows.size)
    val canvas = Canvas(image)
    val paint = Paint()
    map.rows.forEachIndexed { row, cells ->
        var from = 0
        while (from < columns) {
            var to = from + 1
            while (to < columns && cells[to] == cells[from]) to++
            val grey = cells[from].digitToIntOrNull(HEXADECIMAL)
            if (grey != null) {
                paint.color = greyColour(grey / (HEXADECIMAL - 1.0))
                canvas.drawRect(from.toFloat(), row.toFloat(), to.toFloat(), row + 1f, paint)
            }
            from = to
        }
    }
    val corner = transform.toPixels(map.corner.x, map.corner.y)
    val cell = (map.cell * transform.pixelsPerCentimetre).toFloat()
    return MarkDrawing.Picture(
        image,
        Rect(
            Offset(corner.x, corner.y - cell * map.rows.size),
            Size(
                cell * columns,
                cell * map.rows.size,
            ),
        ),
    )
}

internal val Shade.colour: Color
    get() = when (this) {
        is Shade.Grey -> greyColour(reflectance)
        is Shade.Colour -> Color(red, green, blue)
    }

internal val Shade.isBlue: Boolean get() = this is Shade.Colour && blue > red + CLEARLY && blue > green + CLEARLY

internal fun greyColour(reflectance: Double): Color = reflectance.toFloat().coerceIn(0f, 1f).let { Color(it, it, it) }

private fun dotStep(transform: SheetTransform) = max(DOT_CENTIMETRES * transform.pixelsPerCentimetre, MIN_DOT_STEP)

/** In rows, and none at the edge. */
private fun dotsWithin(corners: List<Offset>, step: Float): List<Offset> =
    hatching(corners, step, Offset(0f, 1f), step * DOT_PART).chunked(2).flatMap { (one, other) ->
        val from = minOf(one.x, other.x)
        val to = maxOf(one.x, other.x)
        (ceil(from / step).toInt()..floor(to / step).toInt()).map { Offset(it * step, one.y) }
    }

/** Positions every [step] pixels along a polyline through [points]. */
internal fun placesAlong(points: List<Offset>, step: Float): List<Offset> = buildList {
    var next = 0f
    for ((from, to) in points.zipWithNext()) {
        val length = (to - from).getDistance()
        while (next < length) {
            add(from + (to - from) * (next / length))
            next += step
        }
        next -= length
    }
}

private const val HEXADECIMAL = 16

/** The min difference of blue to red and green for a colour that people call blue. */
private const val CLEARLY = 32
private const val DOT_CENTIMETRES = 1f
private const val MIN_DOT_STEP = 6f

/** The size of a dot relative to the distance between two. */
private const val DOT_PART = 0.3f
