package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.StrokeCap
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

    private fun area(number: Int, lamp: Lamp, point: Point): Outline {
        latest[number]?.let { if (it.place == point) return it.area }
        val corners = litArea(point, lamp.direction, lamp.cone, reachOf(lamp.brightness), obstacles)
        return Outline(around(corners)).also { latest[number] = LitByLamp(point, it) }
    }

    private fun shadows(point: Point, reach: Double, things: List<List<Point>>): Outline? =
        Outline(things.mapNotNull { thing -> shadowOf(thing, point, reach)?.let(::around) })
            .takeIf { it.parts.isNotEmpty() }

    private fun around(corners: List<Point>) = Outline.Polyline(corners.map(::toPixels), isClosed = true)
}

/** The distance at which the light of a lamp is too weak to be visible, in centimetres. */
fun reachOf(brightness: Double): Double = REACH_CENTIMETRES * sqrt(brightness)

/** The area lit by a lamp at [place] if nothing moves. */
private class LitByLamp(val place: Point, val area: Outline)

/**
 * @property area null for a full circle.
 * @property shadows its dark parts; null if there are none.
 */
class Glow(val place: Point, val reach: Double, val area: Outline?, val shadows: Outline?)

internal fun DrawTarget.drawGlow(drawing: GlowDrawing, state: SessionState) =
    drawGlow(drawing, drawing.highlighted(state) + drawing.beacons(state))

/** The light of the world's lamps without the shadows of what moves. */
internal fun DrawTarget.drawStandingGlow(drawing: GlowDrawing, state: SessionState) =
    drawGlow(drawing, drawing.highlighted(state, withShadows = false))

private fun DrawTarget.drawGlow(drawing: GlowDrawing, glows: List<Glow>) {
    for (glow in glows) {
        val radius = drawing.toPixels(glow.reach)
        if (radius <= 0f) continue
        val shine: DrawTarget.() -> Unit = { light(drawing.toPixels(glow.place), radius, glow.area) }
        if (glow.shadows == null) shine() else outside(glow.shadows, shine)
    }
}

/** The lamps: a bulb with rays, or in a shade that is open towards its cone; grey while off. */
internal fun DrawTarget.drawLamps(world: World, state: SessionState, transform: SheetTransform) {
    for ((lamp, now) in world.lamps.zip(state.lamps)) {
        val radius = max(BULB_CENTIMETRES * transform.pixelsPerCentimetre, MIN_BULB_PIXELS * transform.least)
        drawLamp(lamp, now.on, transform.toPixels(now.place), radius)
    }
}

private fun DrawTarget.drawLamp(lamp: Lamp, on: Boolean, position: Offset, radius: Float) {
    val edge = if (on) SheetColours.LAMP_EDGE else SheetColours.LAMP_SHADE
    if (lamp.cone < Lamp.ALL_ROUND) {
        val closed = Lamp.ALL_ROUND.toFloat() - lamp.cone.toFloat()
        val from = -lamp.direction.toFloat() + lamp.cone.toFloat() / 2
        arc(position, radius * SHADE, from, closed, SheetColours.LAMP_SHADE, Line(radius / 2, StrokeCap.Round))
    } else {
        for (ray in 0 until RAYS) {
            val angle = ray * 2 * PI / RAYS
            val way = Offset(cos(angle).toFloat(), sin(angle).toFloat())
            line(position + way * (radius * 1.35f), position + way * (radius * 1.8f), edge, radius / 5, isRound = true)
        }
    }
    disc(position, radius, bulbColour(lamp, on))
    if (on) disc(position, radius * CORE, SheetColours.LAMP_CORE)
    disc(position, radius, fill = null, edge, radius / 6)
}

/** The bulb of a lamp: grey while it is off, violet if it sends infrared light. */
private fun bulbColour(lamp: Lamp, on: Boolean): Color = when {
    !on -> SheetColours.LAMP_OFF
    lamp.infrared -> SheetColours.LAMP_INFRARED
    else -> SheetColours.LAMP
}

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

/** The radius of a shade, relative to that of its bulb. */
private const val SHADE = 1.6f
private const val REACH_CENTIMETRES = 45.0
private const val BULB_CENTIMETRES = 1.3f
private const val MIN_BULB_PIXELS = 4f
private const val RAYS = 8
