package robotran.ui.sheet.svg

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.simulation.state.SessionState
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetDrawing
import robotran.ui.sheet.SheetTransform
import robotran.ui.sheet.drawGlow
import robotran.ui.sheet.drawInk
import robotran.ui.sheet.drawOnPaper
import robotran.ui.sheet.drawRegion
import robotran.ui.sheet.drawThings
import robotran.world.World
import robotran.world.robot.box

/**
 * Writes the sheet and everything on it as an SVG picture, as on a canvas with a pixel per centimetre.
 */
class SheetSvg(private val world: World, private val state: SessionState) {
    private val svg = SvgWriter()
    private val paper = Rect(Offset.Zero, Size(world.paper.width.toFloat(), world.paper.height.toFloat()))
    private val drawing = SheetDrawing(world, SheetTransform(1f, paper, VISIBLE))

    fun write(): String {
        val paper = world.paper
        val wide = paper.width + 2 * MARGIN
        val high = paper.height + 2 * MARGIN
        svg.element(
            "svg",
            "xmlns" to "http://www.w3.org/2000/svg",
            "viewBox" to "${figure(-MARGIN)} ${figure(-MARGIN)} ${figure(wide)} ${figure(high)}",
            "width" to WIDTH,
            "height" to WIDTH * high / wide,
            "role" to "img",
            "font-family" to "sans-serif",
        ) {
            svg.textElement("title", world.title)
            if (world.task.isNotEmpty()) svg.textElement("desc", world.task)
            writeContent(MARGIN)
        }
        return svg.toString()
    }

    /**
     * Writes the [part] of the paper, in centimetres from its upper left corner, as an element of a larger picture that
     * fills [room] there.
     */
    fun writeInto(other: SvgWriter, part: Rect, room: Rect) = other.element(
        "svg",
        "x" to room.left,
        "y" to room.top,
        "width" to room.width,
        "height" to room.height,
        "viewBox" to listOf(part.left, part.top, part.width, part.height).joinToString(" ") { figure(it) },
        "font-family" to "sans-serif",
    ) {
        writeContent(margin = 0.0)
        other.nested(svg)
    }

    private fun writeContent(margin: Double) {
        val all = paper.inflate(margin.toFloat())
        val target = SvgTarget(svg, VISIBLE, all)
        with(target) {
            box(all, SheetColours.LIGHT.desk)
            box(paper, SheetColours.LIGHT.paper)
            drawOnPaper(drawing)
            for (region in drawing.regions) drawRegion(region, state.goals, drawing.transform)
            drawInk(drawing.ink, state.ink, world.robots, visible = all)
            drawGlow(drawing.glow, state)
            drawThings(drawing, state)
        }
        if (world.robots.size > 1) names(target)
    }

    private fun names(target: SvgTarget) {
        for ((place, now) in world.robots.zip(state.robots)) {
            val pose = now.robot.pose
            val middle = drawing.transform.toPixels(pose.x, pose.y - place.description.box.top - NAME_DOWN)
            target.name(place.name, middle, NAME_SIZE, SheetColours.LABEL)
        }
    }

    private companion object {
        /** The desk around the paper. */
        const val MARGIN = 2.0

        /** In pixels, the default size for programs that need one. */
        const val WIDTH = 1200.0

        /** A millimetre. */
        const val VISIBLE = 0.1f
        const val NAME_SIZE = 2.4f

        /** From a robot's lower end to the middle of its name. */
        const val NAME_DOWN = 1.56
    }
}
