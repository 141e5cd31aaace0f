package robotran.narration

import robotran.world.Paper
import robotran.world.geometry.Bounds
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.sqrt

/**
 * How far a robot at [pose] could go straight to one [side] until all that it takes up, its [box], meets something.
 * Distances count from the edge of the robot on that side.
 */
internal class Sweep(private val pose: Pose, side: RobotSide, box: Bounds) {
    private val direction = Direction(pose.heading + side.degrees)

    /** From the point between the wheels to the edge of the robot on that side. */
    private val front: Double

    /** What is further to the right or left of the way does not stop the robot. */
    private val right: Double
    private val left: Double

    init {
        val (reach, from, to) = when (side) {
            RobotSide.AHEAD -> Triple(box.right, box.bottom, box.top)
            RobotSide.LEFT -> Triple(box.top, -box.right, -box.left)
            RobotSide.BEHIND -> Triple(-box.left, -box.top, -box.bottom)
            RobotSide.RIGHT -> Triple(-box.bottom, box.left, box.right)
        }
        front = reach
        right = from + GRAZING
        left = to - GRAZING
    }

    /** Null if it is not in the way. */
    fun distanceTo(outline: Outline): Double? {
        val along = when (outline) {
            is Outline.Round -> along(outline)
            is Outline.Angular -> along(outline.corners)
        }
        return along?.let { (it - front).coerceAtLeast(0.0) }
    }

    /** Of the middle of the robot's edge from that of the sheet; null if the robot is beside the sheet. */
    fun distanceToEdge(paper: Paper): Double? {
        val place = onSheet(pose.point, paper) ?: return null
        val x = if (direction.cosine > 0) paper.width - place.x else place.x
        val y = if (direction.sine > 0) paper.height - place.y else place.y
        val along = minOf(x / maxOf(abs(direction.cosine), TINY), y / maxOf(abs(direction.sine), TINY))
        return (along - front).coerceAtLeast(0.0)
    }

    private fun along(round: Outline.Round): Double? {
        val centre = turned(round.centre)
        val aside = when {
            centre.y < right -> right - centre.y
            centre.y > left -> centre.y - left
            else -> 0.0
        }
        if (aside >= round.radius) return null
        val half = sqrt(round.radius * round.radius - aside * aside)
        return maxOf(centre.x - half, 0.0).takeIf { centre.x + half >= 0 }
    }

    private fun along(corners: List<Point>): Double? {
        val seen = corners.map(::turned)
        var least: Double? = null
        for (number in seen.indices) {
            val reached = along(seen[number], seen[(number + 1) % seen.size]) ?: continue
            least = minOf(reached, least ?: reached)
        }
        return least
    }

    /** The least distance ahead of the part of an edge that is in the way. */
    private fun along(from: Point, to: Point): Double? {
        var start = 0.0
        var end = 1.0
        val rise = to.y - from.y
        if (rise == 0.0) {
            if (from.y !in right..left) return null
        } else {
            val one = (right - from.y) / rise
            val other = (left - from.y) / rise
            start = maxOf(start, minOf(one, other))
            end = minOf(end, maxOf(one, other))
        }
        if (start > end) return null
        val ends = listOf(from.x + start * (to.x - from.x), from.x + end * (to.x - from.x))
        return maxOf(ends.min(), 0.0).takeIf { ends.max() >= 0 }
    }

    /** The point as the robot sees it that goes to that side: x ahead, y to the left. */
    private fun turned(point: Point): Point {
        val x = point.x - pose.x
        val y = point.y - pose.y
        return Point(x * direction.cosine + y * direction.sine, y * direction.cosine - x * direction.sine)
    }

    private companion object {
        /** In centimetres: what the robot only brushes does not stop it. */
        const val GRAZING = 0.3
        const val TINY = 1e-9
    }
}

/** The place on the sheet of a point that is on it, or by less than the width of a pen beside it; otherwise null. */
internal fun onSheet(point: Point, paper: Paper): Point? {
    val near = Point(point.x.coerceIn(0.0, paper.width), point.y.coerceIn(0.0, paper.height))
    return near.takeIf { apart(it, point) <= EDGE }
}

/** In centimetres. */
private const val EDGE = 0.5
