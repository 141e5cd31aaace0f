package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Brush
import androidx.compose.ui.graphics.ClipOp
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.clipPath
import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.world.Lamp
import robotran.world.World
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.max
import kotlin.math.sin
import kotlin.math.sqrt

/** The areas lit by lamps; cached while a lamp does not move. */
class GlowDrawing(private val world: World, private val transform: SheetTransform) {
    private val obstacles: List<List<Point>> =
        world.walls.map { it.corners() } + world.barriers.map { it.shape.corners() }
    private val latest = arrayOfNulls<LitByLamp>(world.lamps.size)

    /** The lamps that are on, with their lit areas and the shadows of robots and blocks. */
    fun highlighted(state: SessionState, withShadows: Boolean = true): List<Glow> {
        if (world.lamps.isEmpty()) return emptyList()
        val things = if (!withShadows) {
            emptyList()
        } else {
            robotOutlines(world, state) +
                world.blocks.zip(state.blocks) { block, moved -> block.shape.movedCorners(moved) }
        }
        return world.lamps.zip(state.lamps).mapIndexedNotNull { number, (lamp, now) ->
            if (!now.on || lamp.infrared || lamp.brightness <= 0) return@mapIndexedNotNull null
            val reach = reachOf(lamp.brightness)
            Glow(now.place, reach, area(number, lamp, now.place), shadows(now.place, reach, things))
        }
    }

    /** The lights on top of robots shine in all directions, too low for shadows to matter. */
    fun beacons(state: SessionState): List<Glow> =
        world.robots.zip(state.robots).filter { (robot, _) -> robot.beacon > 0 }.map { (robot, now) ->
            Glow(Point(now.robot.pose.x, now.robot.pose.y), reachOf(robot.beacon), null, null)
        }

    fun toPixels(point: Point): Offset = transform.toPixels(point)

    fun toPixels(length: Double): Float = transform.toPixels(length)

    private fun area(number: Int, lamp: Lamp, point: Point): Path {
        latest[number]?.let { if (it.place == point) return it.path }
        val corners = litArea(point, lamp.direction, lamp.cone, reachOf(lamp.brightness), obstacles)
        val path = Path().apply { addLine(corners.map(::toPixels), closed = true) }
        latest[number] = LitByLamp(point, path)
        return path
    }

    private fun shadows(point: Point, reach: Double, things: List<List<Point>>): Path? {
        val shadows = things.mapNotNull { shadowOf(it, point, reach) }
        if (shadows.isEmpty()) return null
        return Path().apply { for (corners in shadows) addLine(corners.map(::toPixels), closed = true) }
    }
}

/** The distance at which the light of a lamp is too weak to be visible, in centimetres. */
internal fun reachOf(brightness: Double): Double = REACH_CENTIMETRES * sqrt(brightness)

/** The area lit by a lamp at [place] if nothing moves. */
private class LitByLamp(val place: Point, val path: Path)

/**
 * @property area null for a full circle.
 * @property shadows its dark parts; null if there are none.
 */
class Glow(val place: Point, val reach: Double, val area: Path?, val shadows: Path?)

internal fun DrawScope.drawGlow(drawing: GlowDrawing, state: SessionState) =
    drawGlow(drawing, drawing.highlighted(state) + drawing.beacons(state))

/** The light of the world's lamps without the shadows of what moves. */
internal fun DrawScope.drawStandingGlow(drawing: GlowDrawing, state: SessionState) =
    drawGlow(drawing, drawing.highlighted(state, withShadows = false))

private fun DrawScope.drawGlow(drawing: GlowDrawing, glows: List<Glow>) {
    for (glow in glows) {
        val centre = drawing.toPixels(glow.place)
        val radius = drawing.toPixels(glow.reach)
        if (radius <= 0f) continue
        val light = Brush.radialGradient(
            *GLOW_STOPS,
            center = centre,
            radius = radius,
        )
        val shine: DrawScope.() -> Unit = {
            if (glow.area == null) {
                drawCircle(light, radius, centre)
            } else {
                drawPath(glow.area, light)
            }
        }
        if (glow.shadows == null) shine() else clipPath(glow.shadows, ClipOp.Difference, shine)
    }
}

/** The lamps: a bulb with rays, or in a shade that is open towards its cone; grey while off. */
internal fun DrawScope.drawLamps(world: World, state: SessionState, transform: SheetTransform) {
    for ((lamp, now) in world.lamps.zip(state.lamps)) {
        val radius = max(BULB_CENTIMETRES * transform.pixelsPerCentimetre, MIN_BULB_PIXELS)
        drawLamp(lamp, now.on, transform.toPixels(now.place.x, now.place.y), radius)
    }
}

private fun DrawScope.drawLamp(lamp: Lamp, on: Boolean, position: Offset, radius: Float) {
    val edge = Stroke(radius / 6)
    if (lamp.cone < Lamp.ALL_ROUND) {
        val box = Size(radius * 3.2f, radius * 3.2f)
        val closed = Lamp.ALL_ROUND.toFloat() - lamp.cone.toFloat()
        val from = -lamp.direction.toFloat() + lamp.cone.toFloat() / 2
        drawArc(
            SheetColours.LAMP_SHADE,
            from,
            closed,
            false,
            position - box.center(),
            box,
            style = Stroke(radius / 2, cap = StrokeCap.Round),
        )
    } else {
        for (ray in 0 until RAYS) {
            val angle = ray * 2 * PI / RAYS
            val way = Offset(cos(angle).toFloat(), sin(angle).toFloat())
            val colour = if (on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE
            drawLine(
                colour,
                position + way * (radius * 1.35f),
                position + way * (radius * 1.8f),
                radius / 5,
                StrokeCap.Round,
            )
        }
    }
    drawCircle(bulbColour(lamp, on), radius, position)
    if (on) drawCircle(SheetColours.LAMP_CORE, radius * CORE, position)
    drawCircle(if (on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE, radius, position, style = edge)
}

/** The bulb of a lamp: grey while it is off, violet if it sends infrared light. */
internal fun bulbColour(lamp: Lamp, on: Boolean): Color = when {
    !on -> SheetColours.LAMP_OFF
    lamp.infrared -> SheetColours.LAMP_INFRARED
    else -> SheetColours.LAMP
}

private fun Size.center() = Offset(width / 2, height / 2)

/** Light falls off quickly at first, then slowly: the parts of a lamp's reach, with the light there. */
internal val GLOW_STOPS = arrayOf(
    0f to SheetColours.LAMP_CORE.copy(alpha = 0.95f),
    0.07f to SheetColours.LAMP_CORE.copy(alpha = 0.7f),
    0.2f to SheetColours.LAMP.copy(alpha = 0.36f),
    0.5f to SheetColours.LAMP.copy(alpha = 0.14f),
    1f to SheetColours.LAMP.copy(alpha = 0f),
)

/** The bright middle of a bulb, relative to its radius. */
private const val CORE = 0.55f
private const val REACH_CENTIMETRES = 45.0
private const val BULB_CENTIMETRES = 1.3f
private const val MIN_BULB_PIXELS = 4f
private const val RAYS = 8
