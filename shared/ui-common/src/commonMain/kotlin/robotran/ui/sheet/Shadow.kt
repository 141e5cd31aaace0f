package robotran.ui.sheet

import robotran.simulation.state.SessionState
import robotran.uikit.*
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.robot.footprint
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/**
 * The shadow of an object with these [corners] within [reach] of a lamp at [point]; null if it is out of reach or the
 * lamp is inside it. Always counter-clockwise, so that overlapping shadows merge.
 */
internal fun shadowOf(corners: List<Point>, point: Point, reach: Double): List<Point>? {
    if (distanceInto(corners, point).let { it <= 0 || it >= reach }) return null
    val middle = Point(corners.sumOf { it.x } / corners.size - point.x, corners.sumOf { it.y } / corners.size - point.y)
    val turns = corners.map { corner ->
        val x = corner.x - point.x
        val y = corner.y - point.y
        atan2(middle.x * y - middle.y * x, middle.x * x + middle.y * y)
    }
    val first = turns.indices.minBy { turns[it] }
    val last = turns.indices.maxBy { turns[it] }
    val span = turns[last] - turns[first]
    if (span >= PI) return null
    val towards = atan2(middle.y, middle.x)
    // So far that the straight edge between two of these directions is outside of the lit area.
    val far = reach / cos(span / 4)
    return listOf(
        corners[first],
        point.towards(towards + turns[first], far),
        point.towards(towards + (turns[first] + turns[last]) / 2, far),
        point.towards(towards + turns[last], far),
        corners[last],
    )
}

/** The convex hull of each robot from above. */
internal fun robotOutlines(world: World, state: SessionState): List<List<Point>> =
    world.robots.zip(state.robots) { place, now -> robotOutline(now.robot.pose, place.description) }

/** The convex hull of a robot from above. */
internal fun robotOutline(pose: Pose, robot: RobotDescription): List<Point> {
    val cosine = cos(pose.heading * RADIANS_PER_DEGREE)
    val sine = sin(pose.heading * RADIANS_PER_DEGREE)
    return robot.footprint.map { Point(pose.x + it.x * cosine - it.y * sine, pose.y + it.x * sine + it.y * cosine) }
}
