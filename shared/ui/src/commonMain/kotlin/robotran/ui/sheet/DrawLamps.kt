package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import robotran.world.Lamp
import robotran.world.Point
import robotran.world.Pose
import robotran.world.SessionState
import robotran.world.World
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sin
import kotlin.math.sqrt

/** What the lamps shine on; remembers it for as long as neither a lamp nor a block is moved. */
internal class GlowDrawing(private val world: World, private val transform: SheetTransform) {
    private val obstacles: List<List<Point>> = world.walls.map { it.corners() } + world.barriers.map { it.shape.corners() }
    private val latest = arrayOfNulls<LitByLamp>(world.lamps.size)

    /** The lamps that shine, each with what it shines on. */
    fun lit(state: SessionState): List<Glow> =
        world.lamps.zip(state.lamps).mapIndexedNotNull { number, (lamp, now) ->
            if (!now.on || lamp.brightness <= 0) return@mapIndexedNotNull null
            Glow(now.place, reachOf(lamp.brightness), area(number, lamp, now.place, state.blocks))
        }

    /** The lights on top of robots, which shine all round, and too low for shadows to matter. */
    fun beacons(state: SessionState): List<Glow> =
        world.robots.zip(state.robots).filter { (robot, _) -> robot.beacon > 0 }.map { (robot, now) ->
            Glow(Point(now.robot.pose.x, now.robot.pose.y), reachOf(robot.beacon), null)
        }

    fun toPixels(point: Point): Offset = transform.toPixels(point.x, point.y)

    fun toPixels(length: Double): Float = (length * transform.pixelsPerCentimetre).toFloat()

    private fun area(number: Int, lamp: Lamp, place: Point, blocks: List<Pose>): Path {
        latest[number]?.let { if (it.place == place && it.blocks == blocks) return it.path }
        val inTheWay = obstacles + world.blocks.zip(blocks) { block, moved -> block.shape.movedCorners(moved) }
        val corners = litArea(place, lamp.direction, lamp.cone, reachOf(lamp.brightness), inTheWay)
        val path = Path().apply { addLine(corners.map(::toPixels), closed = true) }
        latest[number] = LitByLamp(place, blocks, path)
        return path
    }

    /** Where the light has become too weak to be seen. */
    private fun reachOf(brightness: Double) = REACH_CENTIMETRES * sqrt(brightness)
}

/** What a lamp at [place] shone on while the blocks were there. */
private class LitByLamp(val place: Point, val blocks: List<Pose>, val path: Path)

/** @property area null for all around. */
internal class Glow(val place: Point, val reach: Double, val area: Path?)

internal fun DrawScope.drawGlow(drawing: GlowDrawing, state: SessionState) {
    for (glow in drawing.lit(state) + drawing.beacons(state)) {
        val centre = drawing.toPixels(glow.place)
        val radius = drawing.toPixels(glow.reach)
        if (radius <= 0f) continue
        val light = Brush.radialGradient(
            0f to SheetColours.LAMP.copy(alpha = 0.6f), 0.15f to SheetColours.LAMP.copy(alpha = 0.4f),
            0.5f to SheetColours.LAMP.copy(alpha = 0.15f), 1f to SheetColours.LAMP.copy(alpha = 0f),
            center = centre, radius = radius,
        )
        if (glow.area == null) drawCircle(light, radius, centre) else drawPath(glow.area, light)
    }
}

/** The lamps themselves: a bulb with rays, or in a shade that is open where its cone shines; grey while they are off. */
internal fun DrawScope.drawLamps(world: World, state: SessionState, transform: SheetTransform) {
    for ((lamp, now) in world.lamps.zip(state.lamps)) {
        val radius = max(BULB_CENTIMETRES * transform.pixelsPerCentimetre, LEAST_BULB_PIXELS)
        drawLamp(lamp, now.on, transform.toPixels(now.place.x, now.place.y), radius)
    }
}

private fun DrawScope.drawLamp(lamp: Lamp, on: Boolean, place: Offset, radius: Float) {
    val edge = Stroke(radius / 6)
    if (lamp.cone < Lamp.ALL_ROUND) {
        val box = Size(radius * 3.2f, radius * 3.2f)
        val closed = Lamp.ALL_ROUND.toFloat() - lamp.cone.toFloat()
        val from = -lamp.direction.toFloat() + lamp.cone.toFloat() / 2
        drawArc(SheetColours.LAMP_SHADE, from, closed, false, place - box.center(), box, style = Stroke(radius / 2, cap = StrokeCap.Round))
    } else {
        for (ray in 0 until RAYS) {
            val angle = ray * 2 * PI / RAYS
            val way = Offset(cos(angle).toFloat(), sin(angle).toFloat())
            val colour = if (on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE
            drawLine(colour, place + way * (radius * 1.35f), place + way * (radius * 1.8f), radius / 5, StrokeCap.Round)
        }
    }
    drawCircle(if (on) SheetColours.LAMP else SheetColours.LAMP_OFF, radius, place)
    drawCircle(if (on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE, radius, place, style = edge)
}

private fun Size.center() = Offset(width / 2, height / 2)

private const val REACH_CENTIMETRES = 45.0
private const val BULB_CENTIMETRES = 1.3f
private const val LEAST_BULB_PIXELS = 4f
private const val RAYS = 8
