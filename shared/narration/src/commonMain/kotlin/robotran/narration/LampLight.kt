package robotran.narration

import robotran.simulation.state.SessionState
import robotran.world.Lamp
import robotran.world.Light
import robotran.world.World
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.cross
import robotran.world.geometry.distance
import robotran.world.geometry.normalHeading
import kotlin.math.abs

/** The indices of the lamps whose light is clearly seen at [point]: those that are on, and that nothing hides. */
internal fun lampsSeenAt(world: World, session: SessionState, point: Point): List<Int> {
    val bodies by lazy { bodiesOf(world, session).filter { it.robot == null } }
    return world.lamps.indices.filter { number ->
        val now = session.lamps.getOrNull(number)
        now != null && now.on && world.lamps[number].reaches(point, now.place) &&
            bodies.none { it.hides(now.place, point) }
    }
}

private fun Lamp.reaches(point: Point, place: Point): Boolean {
    val far = maxOf(apart(point, place), Light.NEAREST)
    val share = Light.LAMP_DISTANCE / far
    if (infrared || Light.LAMP * brightness * share * share < CLEAR) return false
    if (cone >= Lamp.ALL_ROUND) return true
    return abs(normalHeading(directionOf(point.x - place.x, point.y - place.y) - normal(direction))) <= cone / 2
}

/** In (-180, 180] degrees. */
internal fun normal(degrees: Double): Double = normalHeading(degrees % FULL_TURN)

private fun Body.hides(lamp: Point, point: Point): Boolean {
    if (contains(lamp) || contains(point)) return false
    return when (val outline = outline) {
        is Outline.Round -> distance(outline.centre, lamp, point) < outline.radius

        is Outline.Angular -> outline.corners.indices.any {
            cross(lamp, point, outline.corners[it], outline.corners[(it + 1) % outline.corners.size])
        }
    }
}

/** As much light as there is in a dim room anyway. */
private const val CLEAR = Light.DIM_ROOM
private const val FULL_TURN = 360.0
