package robotran.ui.sheet.svg

import robotran.simulation.state.InkStroke
import robotran.simulation.state.SessionState
import robotran.ui.sheet.RobotColours
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.goalRegions
import robotran.ui.sheet.penbotFace
import robotran.world.Lamp
import robotran.world.Penbot
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.robot.box

/** Writes the sheet and everything on it as an SVG picture; a unit is a centimetre, y points down. */
class SheetSvg(private val world: World, private val state: SessionState) {
    private val svg = SvgWriter()
    private val shapes = SvgShapes(svg, world.paper.height)
    private val elements = SvgElements(svg, shapes)
    private val regions = SvgRegions(svg, shapes)
    private val lamps = SvgLamps(svg, shapes)

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

    /** Writes the paper alone as an element of a larger picture, [width] by [height] of its units from [left], [top]. */
    fun writeInto(other: SvgWriter, left: Double, top: Double, width: Double, height: Double) = other.element(
        "svg",
        "x" to left,
        "y" to top,
        "width" to width,
        "height" to height,
        "viewBox" to "0 0 ${figure(world.paper.width)} ${figure(world.paper.height)}",
        "font-family" to "sans-serif",
    ) {
        writeContent(margin = 0.0)
        other.nested(svg)
    }

    private fun writeContent(margin: Double) {
        val paper = world.paper
        val wide = paper.width + 2 * margin
        val high = paper.height + 2 * margin
        SvgDefinitions(svg).write(paper)
        svg.element(
            "rect",
            "x" to -margin,
            "y" to -margin,
            "width" to wide,
            "height" to high,
            "fill" to hex(SheetColours.LIGHT.desk),
        )
        svg.element(
            "rect",
            "width" to paper.width,
            "height" to paper.height,
            "fill" to hex(SheetColours.LIGHT.paper),
        )
        svg.element("g", "clip-path" to "url(#paper)") { world.marks.forEach(elements::mark) }
        world.template?.let(elements::template)
        for (region in goalRegions(world.goals)) regions.region(region, region.isMet(state.goals))
        for (stroke in state.ink.strokes) ink(stroke)
        glows()
        world.walls.forEach(::wall)
        for (barrier in world.barriers) for (fill in SOLID) shapes.shape(barrier.shape, "fill" to fill)
        for ((block, moved) in world.blocks.zip(state.blocks)) elements.block(block.shape, moved)
        world.robots.zip(state.robots).forEachIndexed { number, (place, now) ->
            val face = penbotFace(state, number, drive = place.description.drive)
            SvgRobot(svg).write(place, now.robot, shapes.down(now.robot.pose.y), face)
        }
        for ((lamp, now) in world.lamps.zip(state.lamps)) lamps.lamp(lamp, now)
        if (world.robots.size > 1) names()
    }

    private fun ink(stroke: InkStroke) {
        val colour = hex(RobotColours.ink(stroke.robot, world.robots))
        val single = stroke.points.singleOrNull()
        if (single != null) {
            svg.element(
                "circle",
                "cx" to single.x,
                "cy" to shapes.down(single.y),
                "r" to Penbot.PEN_LINE_WIDTH / 2,
                "fill" to colour,
            )
        } else {
            shapes.line(stroke.points, closed = false, Penbot.PEN_LINE_WIDTH, "stroke" to colour)
        }
    }

    private fun glows() {
        for ((lamp, now) in world.lamps.zip(state.lamps)) {
            if (now.on && !lamp.infrared) lamps.glow(now.place, lamp.brightness, lamp.direction, lamp.cone)
        }
        for ((place, now) in world.robots.zip(state.robots)) {
            lamps.glow(Point(now.robot.pose.x, now.robot.pose.y), place.beacon, direction = 0.0, cone = Lamp.ALL_ROUND)
        }
    }

    /** A line with square ends has the exact shape of a wall. */
    private fun wall(wall: Wall) {
        for (colour in SOLID) {
            svg.element(
                "line",
                "x1" to wall.from.x,
                "y1" to shapes.down(wall.from.y),
                "x2" to wall.to.x,
                "y2" to shapes.down(wall.to.y),
                "stroke" to colour,
                "stroke-width" to wall.thickness,
                "stroke-linecap" to "square",
            )
        }
    }

    private fun names() {
        for ((place, now) in world.robots.zip(state.robots)) {
            val pose = now.robot.pose
            shapes.label(place.name, Point(pose.x, pose.y - place.description.box.top - NAME_SIZE), NAME_SIZE)
        }
    }

    private companion object {
        /** The desk around the paper. */
        const val MARGIN = 2.0

        /** In pixels, the default size for programs that need one. */
        const val WIDTH = 1200.0
        const val NAME_SIZE = 2.4

        /** Drawn on top of each other. */
        val SOLID = listOf(hex(SheetColours.WALL), "url(#hatching)")
    }
}
