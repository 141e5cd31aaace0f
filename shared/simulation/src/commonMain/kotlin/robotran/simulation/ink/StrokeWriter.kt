package robotran.simulation.ink

import robotran.simulation.config.SimulationLimits
import robotran.simulation.state.InkStroke
import robotran.world.geometry.Point
import robotran.world.geometry.cross
import robotran.world.geometry.distance
import robotran.world.geometry.length

/**
 * One stroke during the drawing. It stores a corner where the line bends: from the last corner a straight segment
 * follows the pen as long as it stays within [SimulationLimits.INK_TOLERANCE] of every point. A sector of allowed
 * directions checks this without storing the points.
 */
internal class StrokeWriter(start: Point) {
    private val corners = GrowingList<Point>().apply { add(start) }

    /**
     * The end of the current segment, and the directions it may still take; null while the pen is at the last corner.
     */
    private var end: Point? = null
    private var leftmost = start
    private var rightmost = start

    /** Number of points of the stroke. */
    val size: Int get() = if (end == null) corners.size else corners.size + 1

    fun moveTo(point: Point) {
        if (!extend(point)) {
            end?.let(corners::add)
            end = null
            extend(point)
        }
    }

    /** The stroke so far, drawn by the robot at index [robot]. */
    fun stroke(robot: Int) = InkStroke(points(), robot)

    /** Its corners so far. */
    fun points(): List<Point> = corners.view(listOfNotNull(end))

    /** Extends the segment from the last corner to [point] if possible; returns whether it did. */
    private fun extend(point: Point): Boolean {
        val corner = corners.last()
        val way = Point(point.x - corner.x, point.y - corner.y)
        val distance = length(way.x, way.y)
        val before = end
        if (before == null) {
            if (distance > TOLERANCE) begin(point, way, distance)
            return true
        }
        val reached = length(before.x - corner.x, before.y - corner.y)
        if (distance < reached - TOLERANCE || cross(leftmost, way) > 0 || cross(rightmost, way) < 0) return false
        if (distance > reached) {
            end = point
            val (left, right) = sector(way, distance)
            if (cross(leftmost, left) < 0) leftmost = left
            if (cross(rightmost, right) > 0) rightmost = right
        }
        return true
    }

    private fun begin(point: Point, way: Point, distance: Double) {
        end = point
        val (left, right) = sector(way, distance)
        leftmost = left
        rightmost = right
    }

    /** The directions from a corner that pass within the tolerance of the point at offset [way]. */
    private fun sector(way: Point, distance: Double): Pair<Point, Point> {
        val sine = TOLERANCE / distance
        val cosine = kotlin.math.sqrt(1 - sine * sine)
        return Point(way.x * cosine - way.y * sine, way.y * cosine + way.x * sine) to
            Point(way.x * cosine + way.y * sine, way.y * cosine - way.x * sine)
    }

    /** Positive if [second] points to the left of [first]. */
    private fun cross(first: Point, second: Point) = first.x * second.y - first.y * second.x

    private companion object {
        const val TOLERANCE = SimulationLimits.INK_TOLERANCE
    }
}
