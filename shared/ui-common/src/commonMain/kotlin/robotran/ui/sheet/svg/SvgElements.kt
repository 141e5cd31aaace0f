package robotran.ui.sheet.svg

import androidx.compose.ui.graphics.Color
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.colour
import robotran.ui.sheet.greyColour
import robotran.ui.sheet.isBlue
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Template
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import kotlin.math.min

/** Writes marks, templates and blocks. */
internal class SvgElements(private val svg: SvgWriter, private val shapes: SvgShapes) {
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

            is MarkFigure.GreyMap -> greyMap(figure)
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

    private fun outline(colour: Color, width: Double) =
        arrayOf<Pair<String, Any?>>("fill" to "none", "stroke" to hex(colour), "stroke-width" to width)

    private companion object {
        const val TEMPLATE_WIDTH = 0.5
        const val HEXADECIMAL = 16
        val RINGS = listOf(0.25, 0.5, 0.75)
    }
}

/** The sizes of the patterns of dots and of grain, in centimetres. */
internal const val DOT_STEP = 1.0
internal const val DOT_SIZE = 0.3
internal const val GRAIN_WIDTH = 0.15
