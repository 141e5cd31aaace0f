package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
import robotran.ui.sheet.Dots
import robotran.ui.sheet.DrawTarget
import robotran.ui.sheet.GLOW_STOPS
import robotran.ui.sheet.GreyCells
import robotran.ui.sheet.Line
import robotran.ui.sheet.Outline
import robotran.uikit.*
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/**
 * Writes elements of an SVG picture.
 *
 * @param extent where it may draw.
 */
internal class SvgTarget(private val svg: SvgWriter, override val dp: Float, private val extent: Rect) : DrawTarget {
    override val hasText: Boolean get() = true

    /** How many lights and clips have a name by now. */
    private var names = 0

    override fun shape(outline: Outline, fill: Color?, edge: Color?, line: Line) {
        val look = arrayOf(*filled(fill), *drawn(edge, line))
        when (val part = outline.parts.singleOrNull()) {
            is Outline.Circle -> svg.element("circle", *circle(part.middle, part.radius), *look)

            is Outline.Polyline -> {
                svg.element(if (part.isClosed) "polygon" else "polyline", "points" to parameters(part.points), *look)
            }

            null -> svg.element("path", "d" to outline.parts.joinToString("", transform = ::pathData), *look)
        }
    }

    private fun pathData(part: Outline.Part): String = when (part) {
        is Outline.Polyline -> "M" + parameters(part.points) + if (part.isClosed) "Z" else ""

        is Outline.Circle -> {
            val radius = figure(part.radius)
            val width = figure(2 * part.radius)
            val start = parameter(part.middle - Offset(part.radius, 0f))
            "M${start}a$radius,$radius 0 1 0 $width,0a$radius,$radius 0 1 0 -$width,0Z"
        }
    }

    override fun box(bounds: Rect, fill: Color, corner: Float, edge: Color?, width: Float) =
        svg.element("rect", *place(bounds), "rx" to corner.takeIf { it > 0 }, *filled(fill), *drawn(edge, Line(width)))

    override fun disc(middle: Offset, radius: Float, fill: Color?, edge: Color?, width: Float) =
        svg.element("circle", *circle(middle, radius), *filled(fill), *drawn(edge, Line(width)))

    override fun arc(middle: Offset, radius: Float, from: Float, sweep: Float, colour: Color, line: Line?) {
        val (start, end) = listOf(from, from + sweep).map {
            val angle = it * PI / HALF_TURN
            parameter(middle + Offset(cos(angle).toFloat(), sin(angle).toFloat()) * radius)
        }
        val isLong = if (sweep > HALF_TURN) 1 else 0
        val look = if (line == null) filled(colour) else arrayOf(*filled(null), *drawn(colour, line))
        svg.element("path", "d" to "M${start}A${figure(radius)},${figure(radius)} 0 $isLong 1 $end", *look)
    }

    override fun lines(ends: List<Offset>, colour: Color, width: Float, isRound: Boolean) {
        val path = ends.chunked(2).joinToString("") { "M" + parameters(it) }
        val line = Line(width, if (isRound) StrokeCap.Round else StrokeCap.Butt)
        if (path.isNotEmpty()) svg.element("path", "d" to path, *filled(null), *drawn(colour, line))
    }

    /** Dashes of zero length with round ends are dots. */
    override fun dots(dots: Dots, colour: Color) {
        val (straight, others) = dots.rows.filter { it.isNotEmpty() }.partition { it.first().y == it.last().y }
        val rows = straight.map { "M${parameter(it.first())}H${figure(it.last().x + dots.step * A_LITTLE)}" }
        val single = others.flatten().map { "M${parameter(it)}h0" }
        for ((path, dashes) in listOf(rows to (0f to dots.step), single to null)) {
            if (path.isEmpty()) continue
            svg.element(
                "path",
                "d" to path.joinToString(""),
                *filled(null),
                *drawn(colour, Line.round(dots.size, dashes)),
            )
        }
    }

    override fun light(middle: Offset, radius: Float, area: Outline?) {
        val name = "light${++names}"
        val (x, y, r) = circle(middle, radius).map { it.second }
        svg.element(
            "radialGradient",
            "id" to name,
            "gradientUnits" to "userSpaceOnUse",
            "cx" to x,
            "cy" to y,
            "r" to r,
        ) {
            for ((place, colour) in GLOW_STOPS) {
                svg.element("stop", "offset" to place, "stop-color" to hex(colour), "stop-opacity" to colour.alpha)
            }
        }
        val fill = "fill" to "url(#$name)"
        val corners = (area?.parts?.single() as? Outline.Polyline)?.points
        if (corners == null) {
            svg.element("circle", *circle(middle, radius), fill)
        } else {
            svg.element("polygon", "points" to parameters(corners), fill)
        }
    }

    override fun cells(cells: GreyCells, place: Rect) = svg.element("g", "shape-rendering" to "crispEdges") {
        val size = place.height / cells.rows
        for (run in cells.runs) {
            val corner = place.topLeft + Offset(run.from * size, run.row * size)
            box(Rect(corner.x, corner.y, corner.x + (run.to - run.from) * size, corner.y + size), run.colour)
        }
    }

    override fun text(text: String, middle: Offset, height: Float, colour: Color) =
        text(text, middle, height, "fill" to hex(colour))

    /** With a light edge, which makes it legible on whatever is below. */
    fun name(text: String, middle: Offset, height: Float, colour: Color) = text(
        text,
        middle,
        height,
        "fill" to hex(colour),
        "stroke" to "#ffffff",
        "stroke-width" to height / 6,
        "paint-order" to "stroke",
    )

    private fun text(text: String, middle: Offset, height: Float, vararg look: Pair<String, Any?>) = svg.textElement(
        "text",
        text,
        "x" to middle.x,
        "y" to middle.y + height * HALF_LETTER,
        "font-size" to height,
        "text-anchor" to "middle",
        "font-weight" to "bold",
        *look,
    )

    override fun group(move: Offset, degrees: Float, pivot: Offset, scale: Float, content: DrawTarget.() -> Unit) {
        val steps = listOfNotNull(
            "translate(${figure(move.x)} ${figure(move.y)})",
            "rotate(${figure(degrees)}${if (pivot == Offset.Zero) "" else " " + parameter(pivot, " ")})"
                .takeIf { degrees != 0f },
            "scale(${figure(scale)})".takeIf { scale != 1f },
        )
        svg.element("g", "transform" to steps.joinToString(" ")) { content() }
    }

    override fun inside(bounds: Rect, content: DrawTarget.() -> Unit) {
        val name = "clip${++names}"
        svg.element("clipPath", "id" to name) { svg.element("rect", *place(bounds)) }
        svg.element("g", "clip-path" to "url(#$name)") { content() }
    }

    override fun outside(outline: Outline, content: DrawTarget.() -> Unit) {
        val name = "clip${++names}"
        svg.element("mask", "id" to name, "maskUnits" to "userSpaceOnUse", *place(extent)) {
            box(extent, RobotranColours.CASING)
            shape(outline, RobotranColours.SHADE)
        }
        svg.element("g", "mask" to "url(#$name)") { content() }
    }

    private companion object {
        const val HALF_TURN = 180

        /** How far the line of a row of dots goes on, so that the last one is on it. */
        const val A_LITTLE = 0.1f

        /** From the middle of a text down to where its letters stand, relative to the font's height. */
        const val HALF_LETTER = 0.35f
    }
}
