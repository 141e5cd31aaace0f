package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color

/**
 * What the things of a sheet are drawn on: the canvas of a screen or a picture ([CanvasTarget]), or a file of lines
 * ([robotran.ui.sheet.svg.SvgTarget]). Lengths are the target's own units, y points down, and angles are clockwise from
 * the right, in degrees.
 */
interface DrawTarget {
    /** The size of a dp, for what must stay visible in small pictures. */
    val dp: Float

    /** Whether it has fonts; without, [text] draws nothing. */
    val hasText: Boolean

    /** Draws the inside of [outline] in the colour [fill], then its [edge] with [line]. */
    fun shape(outline: Outline, fill: Color? = null, edge: Color? = null, line: Line = Line(0f))

    /** A rectangle with round corners of the radius [corner]; [width] is that of its edge. */
    fun box(bounds: Rect, fill: Color, corner: Float = 0f, edge: Color? = null, width: Float = EDGE_WIDTH)

    /** A circle; [width] is that of its edge. */
    fun disc(middle: Offset, radius: Float, fill: Color?, edge: Color? = null, width: Float = EDGE_WIDTH)

    /** A part of a circle from the angle [from] on: its line, or what is between it and its chord if [line] is null. */
    fun arc(middle: Offset, radius: Float, from: Float, sweep: Float, colour: Color, line: Line? = null)

    /** Lines between pairs of [ends]. */
    fun lines(ends: List<Offset>, colour: Color, width: Float, isRound: Boolean = false)

    fun dots(dots: Dots, colour: Color)

    /** Light that falls off from [middle] to [radius], as [GLOW_STOPS] say: on a circle, or only on [area]. */
    fun light(middle: Offset, radius: Float, area: Outline?)

    /** A picture of squares. */
    fun cells(cells: GreyCells, place: Rect)

    /** A bold text of [height], centred on [middle]. */
    fun text(text: String, middle: Offset, height: Float, colour: Color)

    /** Draws [content] moved by [move], and before that turned by [degrees] around [pivot], and before that [scale] times as large. */
    fun group(
        move: Offset,
        degrees: Float = 0f,
        pivot: Offset = Offset.Zero,
        scale: Float = 1f,
        content: DrawTarget.() -> Unit,
    )

    /** Draws the part of [content] in [bounds]. */
    fun inside(bounds: Rect, content: DrawTarget.() -> Unit)

    /** Draws the part of [content] that is not in [outline]. */
    fun outside(outline: Outline, content: DrawTarget.() -> Unit)
}

/** Of the edges of a robot's parts, in centimetres. */
const val EDGE_WIDTH = 0.15f

internal fun DrawTarget.line(from: Offset, to: Offset, colour: Color, width: Float, isRound: Boolean = false) =
    lines(listOf(from, to), colour, width, isRound)
