package robotran.workshop.state

import androidx.compose.runtime.Immutable
import robotran.simulation.state.SessionState
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import robotran.world.robot.footprint
import kotlin.math.cos
import kotlin.math.sin

/**
 * A robot no part of which is over the paper any more.
 *
 * @property robot its index in the world.
 * @property place where its pen is.
 * @property edge the point of the paper that is nearest to that.
 */
@Immutable
data class StrayedRobot(val robot: Int, val place: Point, val edge: Point)

/** The robots of [world] that have left the paper and have not come back. */
fun strayedRobots(world: World, session: SessionState): List<StrayedRobot> {
    val paper = world.paper
    return world.robots.zip(session.robots).mapIndexedNotNull { index, (placed, now) ->
        val pose = now.robot.pose
        // Most are on it, which takes no trigonometry to see.
        if (pose.x in 0.0..paper.width && pose.y in 0.0..paper.height) return@mapIndexedNotNull null
        val corners = placed.description.footprint.map { it.seenFrom(pose) }
        val isBeside = corners.all { it.x < 0 } || corners.all { it.x > paper.width } ||
            corners.all { it.y < 0 } || corners.all { it.y > paper.height }
        val edge = Point(pose.x.coerceIn(0.0, paper.width), pose.y.coerceIn(0.0, paper.height))
        StrayedRobot(index, Point(pose.x, pose.y), edge).takeIf { isBeside }
    }
}

/** The place of this point of a robot at [pose]. */
private fun Point.seenFrom(pose: Pose): Point {
    val angle = pose.heading * RADIANS_PER_DEGREE
    return Point(pose.x + x * cos(angle) - y * sin(angle), pose.y + x * sin(angle) + y * cos(angle))
}
