package robotran.ui.sheet.svg

import androidx.compose.ui.graphics.Color
import robotran.simulation.state.LampState
import robotran.ui.sheet.GoalRegion
import robotran.ui.sheet.SeamlessPolygon
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.colour
import robotran.ui.sheet.greyColour
import robotran.ui.sheet.isBlue
import robotran.ui.sheet.roomiestPoint
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Paper
import robotran.world.RegionRole
import robotran.world.Template
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import kotlin.math.PI
import kotlin.math.min
import kotlin.math.sqrt

/** Writes all elements on the paper except robots. */
internal class SvgElements(private val svg: SvgWriter, private val shapes: SvgShapes) {
    /** Patterns and clip paths of the other elements. */
    fun definitions(paper: Paper) = svg.element("defs") {
        svg.element("clipPath", "id" to "paper") {
            svg.element("rect", "width" to paper.width, "height" to paper.height)
        }
        pattern("hatching", HATCHING_STEP, "rotate(45)") {
            svg.element(
                "rect",
                "width" to HATCHING_STEP / 3,
                "height" to HATCHING_STEP,
                "fill" to hex(SheetColours.WALL_HATCHING),
            )
        }
        pattern("dots", DOT_STEP, null) {
            svg.element(
                "circle",
                "cx" to DOT_STEP / 2,
                "cy" to DOT_STEP / 2,
                "r" to DOT_SIZE / 2,
                "fill" to hex(SheetColours.MARK_DOTS),
                "fill-opacity" to SheetColours.MARK_DOTS.alpha,
            )
        }
        pattern("grain", GRAIN_STEP, null) {
            svg.element("rect", "width" to GRAIN_STEP, "height" to GRAIN_WIDTH, "fill" to hex(SheetColours.BLOCK_GRAIN))
        }
        svg.element("radialGradient", "id" to "glow") {
            for ((place, strength) in GLOW) {
                svg.element(
                    "stop",
                    "offset" to place,
                    "stop-color" to hex(SheetColours.LAMP),
                    "stop-opacity" to strength,
                )
            }
        }
    }

    private fun pattern(name: String, step: Double, transform: String?, content: () -> Unit) = svg.element(
        "pattern",
        "id" to name,
        "width" to step,
        "height" to step,
        "patternUnits" to "userSpaceOnUse",
        "patternTransform" to transform,
        content = content,
    )

    fun mark(mark: Mark) {
        when (val figure = mark.figure) {
            is MarkFigure.Area -> {
                shapes.shape(figure.shape, "fill" to hex(mark.shade.colour))
                if (mark.shade.isBlue) shapes.shape(figure.shape, "fill" to "url(#dots)")
            }

            is MarkFigure.Line -> {
                shapes.line(figure.points, figure.closed, figure.width, "stroke" to hex(mark.shade.colour))
                if (mark.shade.isBlue) {
                    shapes.line(
                        figure.points,
                        figure.closed,
                        min(DOT_SIZE, figure.width / 2),
                        "stroke" to hex(SheetColours.MARK_DOTS),
                        "stroke-opacity" to SheetColours.MARK_DOTS.alpha,
                        "stroke-dasharray" to "0 ${figure(DOT_STEP)}",
                    )
                }
            }

            is MarkFigure.GreyMap -> {
                greyMap(figure)
            }
        }
    }

    private fun greyMap(map: MarkFigure.GreyMap) = svg.element("g", "shape-rendering" to "crispEdges") {
        map.rows.forEachIndexed { row, cells ->
            var from = 0
            while (from < cells.length) {
                var to = from + 1
                while (to < cells.length && cells[to] == cells[from]) to++
                cells[from].digitToIntOrNull(HEXADECIMAL)?.let { grey ->
                    svg.element(
                        "rect",
                        "x" to map.corner.x + from * map.cell,
                        "y" to shapes.down(map.corner.y + (map.rows.size - row) * map.cell),
                        "width" to (to - from) * map.cell,
                        "height" to map.cell,
                        "fill" to hex(greyColour(grey / (HEXADECIMAL - 1.0))),
                    )
                }
                from = to
            }
        }
    }

    fun template(template: Template) {
        for (stroke in template.strokes) {
            shapes.line(
                stroke,
                closed = false,
                TEMPLATE_WIDTH,
                "stroke" to hex(SheetColours.TEMPLATE),
                "stroke-dasharray" to "0 1",
            )
        }
    }

    fun region(region: GoalRegion, met: Boolean) {
        val (colour, dashes) = when (region.role) {
            RegionRole.TARGET -> SheetColours.REACH to null
            RegionRole.FORBIDDEN -> SheetColours.STAY_OUT to "0.9 0.9"
            RegionRole.PERMITTED -> SheetColours.STAY_IN to "2.4 0.9"
        }
        val fill = when {
            region.role == RegionRole.PERMITTED -> null
            met -> MET_OPACITY
            else -> OPACITY
        }
        val inside = arrayOf("fill" to if (fill == null) "none" else hex(colour), "fill-opacity" to fill)
        val edge = arrayOf("stroke" to hex(colour), "stroke-width" to REGION_LINE, "stroke-dasharray" to dashes)
        val polygon = (region.shape as? Shape.Polygon)?.let(SeamlessPolygon::of)
        val pieces = polygon?.outline
        if (pieces == null) {
            shapes.shape(region.shape, *inside, *edge)
        } else {
            shapes.shape(Shape.Polygon(polygon.corners), *inside)
            for (piece in pieces) {
                svg.element(
                    "polyline",
                    "points" to figures(shapes.down(piece)),
                    "fill" to "none",
                    *edge,
                )
            }
        }
        if (region.role == RegionRole.TARGET) flag(region)
    }

    private fun flag(region: GoalRegion) {
        val (place, room) = roomiestPoint(region.shape)
        val size = min(room * 2 * FLAG_PART, MAX_FLAG)
        val cell = size / 5
        val left = place.x - size * if (region.number == null) 0.4 else 0.65
        val top = shapes.down(place.y) - size / 2
        svg.element("g", "fill" to hex(SheetColours.FLAG)) {
            svg.element("rect", "x" to left - size / 28, "y" to top, "width" to size / 14, "height" to size)
            svg.element("rect", "x" to left, "y" to top, "width" to 4 * cell, "height" to 3 * cell, "fill" to "#ffffff")
            for (row in 0 until FLAG_ROWS) {
                for (column in row % 2 until FLAG_COLUMNS step 2) {
                    svg.element(
                        "rect",
                        "x" to left + column * cell,
                        "y" to top + row * cell,
                        "width" to cell,
                        "height" to cell,
                    )
                }
            }
        }
        region.number?.let { label(it.toString(), Point(place.x + size * 0.55, place.y - size * 0.28), size * 0.8) }
    }

    /** Without shadows, which only the screen shows. */
    fun glow(place: Point, brightness: Double, direction: Double, cone: Double) {
        if (brightness <= 0) return
        val reach = REACH * sqrt(brightness)
        val y = shapes.down(place.y)
        if (cone >= Lamp.ALL_ROUND) {
            svg.element("circle", "cx" to place.x, "cy" to y, "r" to reach, "fill" to "url(#glow)")
            return
        }
        // An arc of radius r/2 with line width r fills a sector, without trigonometry.
        val round = PI * reach
        val lit = round * cone / Lamp.ALL_ROUND
        svg.element(
            "circle",
            "cx" to place.x,
            "cy" to y,
            "r" to reach / 2,
            "fill" to "none",
            "stroke" to hex(SheetColours.LAMP),
            "stroke-opacity" to CONE_OPACITY,
            "stroke-width" to reach,
            "stroke-dasharray" to "${figure(lit)} ${figure(round - lit)}",
            "transform" to "rotate(${figure(-direction - cone / 2)} ${figure(place.x)} ${figure(y)})",
        )
    }

    fun lamp(lamp: Lamp, now: LampState) {
        val y = shapes.down(now.place.y)
        if (lamp.cone < Lamp.ALL_ROUND) {
            val round = 2 * PI * SHADE_RADIUS
            val closed = round * (Lamp.ALL_ROUND - lamp.cone) / Lamp.ALL_ROUND
            svg.element(
                "circle",
                "cx" to now.place.x,
                "cy" to y,
                "r" to SHADE_RADIUS,
                "fill" to "none",
                "stroke" to hex(SheetColours.LAMP_SHADE),
                "stroke-width" to 0.65,
                "stroke-dasharray" to "${figure(closed)} ${figure(round - closed)}",
                "transform" to "rotate(${figure(-lamp.direction + lamp.cone / 2)} ${figure(now.place.x)} ${figure(y)})",
            )
        }
        svg.element(
            "circle",
            "cx" to now.place.x,
            "cy" to y,
            "r" to BULB_RADIUS,
            "stroke-width" to 0.22,
            "fill" to hex(if (now.on) SheetColours.LAMP else SheetColours.LAMP_OFF),
            "stroke" to hex(if (now.on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE),
        )
    }

    /** @param moved its movement and rotation from its place in the world. */
    fun block(shape: Shape, moved: Pose) {
        val turn = shapes.turned(moved.heading, shape.centre)
        val move = "translate(${figure(moved.x)} ${figure(-moved.y)})" + if (turn == null) "" else " $turn"
        svg.element("g", "transform" to move) {
            shapes.shape(shape, "fill" to hex(SheetColours.BLOCK))
            if (shape is Shape.Circle) {
                for (part in RINGS) {
                    shapes.shape(
                        shape.copy(radius = shape.radius * part),
                        *outline(SheetColours.BLOCK_GRAIN, GRAIN_WIDTH),
                    )
                }
            } else {
                shapes.shape(shape, "fill" to "url(#grain)")
            }
            shapes.shape(shape, *outline(SheetColours.BLOCK_EDGE, 2 * GRAIN_WIDTH))
        }
    }

    /** Text centred on a place, with a paper-coloured outline for contrast. */
    fun label(words: String, place: Point, size: Double) = svg.words(
        "text",
        words,
        "x" to place.x,
        "y" to shapes.down(place.y),
        "font-size" to size,
        "text-anchor" to "middle",
        "font-weight" to "bold",
        "fill" to hex(SheetColours.LABEL),
        "stroke" to "#ffffff",
        "stroke-width" to size / 6,
        "paint-order" to "stroke",
    )

    private fun outline(colour: Color, width: Double) =
        arrayOf<Pair<String, Any?>>("fill" to "none", "stroke" to hex(colour), "stroke-width" to width)

    private companion object {
        const val HATCHING_STEP = 0.5
        const val DOT_STEP = 1.0
        const val DOT_SIZE = 0.3
        const val GRAIN_STEP = 1.2
        const val GRAIN_WIDTH = 0.15
        const val TEMPLATE_WIDTH = 0.5
        const val REGION_LINE = 0.3
        const val OPACITY = 0.1
        const val MET_OPACITY = 0.35
        const val FLAG_PART = 0.45
        const val MAX_FLAG = 6.0
        const val FLAG_ROWS = 3
        const val FLAG_COLUMNS = 4
        const val REACH = 45.0
        const val CONE_OPACITY = 0.22
        const val BULB_RADIUS = 1.3
        const val SHADE_RADIUS = 2.08
        const val HEXADECIMAL = 16
        val RINGS = listOf(0.25, 0.5, 0.75)
        val GLOW = listOf(0.0 to 0.6, 0.15 to 0.4, 0.5 to 0.15, 1.0 to 0.0)
    }
}
