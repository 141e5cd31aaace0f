package robotran.simulation.goal

import robotran.world.geometry.Point
import robotran.world.geometry.length

/**
 * Tracks a robot along a line. Where the line approaches or crosses itself, the position reachable from the last one
 * counts.
 *
 * @param tolerance max distance from the line.
 * @param laps receives the positions.
 * @param M what the tracker remembers of a moment.
 */
internal class LineTracker<M>(private val way: ArcLengthPath, private val tolerance: Double, private val laps: Laps) {
    private val reach = minOf(REACH_IN_TOLERANCES * tolerance, way.length / MIN_REACHES_IN_LINE)
    private val maxStray = STRAY_IN_TOLERANCES * tolerance

    /** The last position along the line, null before the robot has reached it. */
    private var at: Double? = null
    private var point: Point? = null

    /** Distance covered beside the line since the robot left it. */
    private var distanceOffLine = 0.0
    private var searchedAt = -SEARCH_DISTANCE

    /** The nearest approach to a line that the robot has not reached; null once it has. */
    var nearest: Approach<M>? = null
        private set

    /** When the robot left the line where it is off it now; null while it is on the line, or never was. */
    var left: M? = null
        private set

    /** When the robot last left the line before it reached it elsewhere, so that the lap began again. */
    var leftForElsewhere: M? = null
        private set

    /** The robot is at [next], at [moment]. */
    fun moveTo(next: Point, moment: M) {
        val moved = point?.let { length(next.x - it.x, next.y - it.y) } ?: 0.0
        if (point != null && moved == 0.0) return
        point = next
        val near = at?.let { way.nearest(next, it - reach, it + reach) }
        if (near != null && near.distance <= tolerance) {
            goOn(near.at)
        } else {
            if (at != null && left == null) left = moment
            distanceOffLine += moved
            if (at == null || distanceOffLine > maxStray) search(next, moment)
        }
    }

    private fun goOn(to: Double) {
        at = to
        left = null
        nearest = null
        distanceOffLine = 0.0
        searchedAt = -SEARCH_DISTANCE
        laps.goOn(to)
    }

    private fun search(point: Point, moment: M) {
        if (distanceOffLine - searchedAt < SEARCH_DISTANCE) return
        searchedAt = distanceOffLine
        val near = way.nearest(point, 0.0, way.length)
        if (near.distance > tolerance) return approach(near, moment)
        left?.let { leftForElsewhere = it }
        laps.restartAt(near.at)
        goOn(near.at)
    }

    private fun approach(near: ArcLengthPath.Nearest, moment: M) {
        val before = nearest
        if (at != null || (before != null && before.centimetres <= near.distance)) return
        nearest = Approach(near.distance, way.pointAt(near.at), moment)
    }

    /**
     * @property centimetres distance from the line.
     * @property target the nearest point of the line.
     */
    class Approach<M>(val centimetres: Double, val target: Point, val moment: M)

    private companion object {
        /** Max progress along the line between two checks: round a bend of 60 degrees, cut within the tolerance. */
        const val REACH_IN_TOLERANCES = 4.0
        const val MIN_REACHES_IN_LINE = 4.0

        /** Max distance beside the line within which the robot rejoins the line only where it left it. */
        const val STRAY_IN_TOLERANCES = 2.0

        /** Min distance the robot covers between two searches of the whole line, in centimetres. */
        const val SEARCH_DISTANCE = 0.5
    }
}
