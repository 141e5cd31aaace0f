package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import robotran.uikit.*
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Shade
import robotran.world.geometry.Shape
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.max

/** A mark prepared for drawing. */
sealed interface MarkDrawing {
    /**
     * An area, or a line of a [width].
     *
     * @property dots mark blue for colour-blind pupils; null for other colours.
     */
    class Painted(val outline: Outline, val colour: Color, val width: Float?, val dots: Dots?) : MarkDrawing

    class Picture(val cells: GreyCells, val place: Rect) : MarkDrawing
}

fun markDrawing(mark: Mark, transform: SheetTransform): MarkDrawing = when (val figure = mark.figure) {
    is MarkFigure.Area -> area(figure.shape, mark.shade, transform)
    is MarkFigure.Line -> line(figure, mark.shade, transform)
    is MarkFigure.GreyMap -> picture(figure, transform)
}

internal fun DrawTarget.drawMark(mark: MarkDrawing) {
    when (mark) {
        is MarkDrawing.Painted -> {
            if (mark.width == null) {
                shape(mark.outline, mark.colour)
            } else {
                shape(mark.outline, edge = mark.colour, line = Line.round(mark.width))
            }
            mark.dots?.let { dots(it, SheetColours.MARK_DOTS) }
        }

        is MarkDrawing.Picture -> cells(mark.cells, mark.place)
    }
}

private fun area(shape: Shape, shade: Shade, transform: SheetTransform): MarkDrawing {
    val step = dotStep(transform)
    val dots = if (shade.isBlue) {
        Dots(
            dotsWithin(shape.corners().map(transform::toPixels), step),
            step,
            step * DOT_PART,
        )
    } else {
        null
    }
    return MarkDrawing.Painted(Outline.of(shape, transform), shade.colour, null, dots)
}

private fun line(line: MarkFigure.Line, shade: Shade, transform: SheetTransform): MarkDrawing {
    val points = line.points.map(transform::toPixels)
    val width = (line.width * transform.pixelsPerCentimetre).toFloat()
    val step = dotStep(transform)
    val middles = if (shade.isBlue) {
        placesAlong(
            if (line.closed) points + points.first() else points,
            step,
        )
    } else {
        emptyList()
    }
    val dots = Dots(listOf(middles), step, minOf(step * DOT_PART, width / 2)).takeIf { middles.isNotEmpty() }
    return MarkDrawing.Painted(Outline(Outline.Polyline(points, line.closed)), shade.colour, width, dots)
}

private fun picture(map: MarkFigure.GreyMap, transform: SheetTransform): MarkDrawing {
    val columns = map.rows.first().length
    val runs = map.rows.flatMapIndexed { row, cells -> runsOf(row, cells) }
    val corner = transform.toPixels(map.corner)
    val cell = (map.cell * transform.pixelsPerCentimetre).toFloat()
    val size = Size(cell * columns, cell * map.rows.size)
    return MarkDrawing.Picture(
        GreyCells(columns, map.rows.size, runs),
        Rect(Offset(corner.x, corner.y - size.height), size),
    )
}

private fun runsOf(row: Int, cells: String): List<GreyCells.Run> = buildList {
    var from = 0
    while (from < cells.length) {
        var to = from + 1
        while (to < cells.length && cells[to] == cells[from]) to++
        cells[from].digitToIntOrNull(HEXADECIMAL)?.let { grey ->
            add(GreyCells.Run(row, from, to, greyColour(grey / (HEXADECIMAL - 1.0))))
        }
        from = to
    }
}

internal val Shade.colour: Color
    get() = when (this) {
        is Shade.Grey -> greyColour(reflectance)
        is Shade.Colour -> Color(red, green, blue)
    }

internal val Shade.isBlue: Boolean get() = this is Shade.Colour && blue > red + CLEARLY && blue > green + CLEARLY

internal fun greyColour(reflectance: Double): Color = reflectance.toFloat().coerceIn(0f, 1f).let { Color(it, it, it) }

private fun dotStep(transform: SheetTransform) =
    max(DOT_CENTIMETRES * transform.pixelsPerCentimetre, MIN_DOT_STEP * transform.least)

/** In rows, and none at the edge. */
private fun dotsWithin(corners: List<Offset>, step: Float): List<List<Offset>> =
    hatching(corners, step, Offset(0f, 1f), step * DOT_PART).chunked(2).map { (one, other) ->
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
