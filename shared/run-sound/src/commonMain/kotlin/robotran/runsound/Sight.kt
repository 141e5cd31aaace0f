package robotran.runsound

import robotran.simulation.state.SessionState
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.centre
import robotran.world.geometry.flat
import robotran.world.geometry.length
import robotran.world.robot.footprint

/** Looks ahead from the front of the robot at index [robot]: from its left edge, its middle and its right edge. */
internal class Sight(private val world: World, private val robot: Int) {
    private val fixed = world.walls.map { it.outline } + world.barriers.map { flat(it.shape) }
    private val blocks = world.blocks.map { flat(it.shape) }
    private val footprints = world.robots.map { it.description.footprint }
    private val front = footprints[robot].maxOf { it.x }
    private val starts = listOf(footprints[robot].maxOf { it.y }, 0.0, footprints[robot].minOf { it.y })

    /** The distance to the next thing ahead; infinite if there is none. */
    fun ahead(state: SessionState): Double {
        val pose = state.robots[robot].robot.pose
        val direction = Direction(pose.heading)
        val rays = starts.map { Ray(direction.from(Point(pose.x, pose.y), front, it), direction) }
        return things(state).minOfOrNull { thing -> rays.minOf { it.distanceTo(thing) } } ?: Double.POSITIVE_INFINITY
    }

    private fun things(state: SessionState): List<Outline> = fixed +
        state.blocks.mapIndexed { number, moved -> movedBlock(number, moved) } +
        state.robots.indices.filter { it != robot }.map { placed(footprints[it], state.robots[it].robot.pose) }

    private fun movedBlock(number: Int, moved: Pose): Outline {
        val centre = world.blocks[number].shape.centre
        val now = Pose(centre.x + moved.x, centre.y + moved.y, moved.heading)
        return when (val outline = blocks[number]) {
            is Outline.Round -> Outline.Round(Point(now.x, now.y), outline.radius)

            is Outline.Angular -> placed(outline.corners.map { Point(it.x - centre.x, it.y - centre.y) }, now)
        }
    }

    private fun placed(corners: List<Point>, pose: Pose): Outline {
        val direction = Direction(pose.heading)
        return Outline.Angular(corners.map { direction.from(Point(pose.x, pose.y), it.x, it.y) })
    }
}

/** A wall with its thickness and its square ends. */
private val Wall.outline: Outline
    get() {
        val along = length(to.x - from.x, to.y - from.y)
        val x = thickness / 2 * if (along == 0.0) 1.0 else (to.x - from.x) / along
        val y = thickness / 2 * if (along == 0.0) 0.0 else (to.y - from.y) / along
        return Outline.Angular(
            listOf(
                Point(from.x - x + y, from.y - y - x),
                Point(to.x + x + y, to.y + y - x),
                Point(to.x + x - y, to.y + y + x),
                Point(from.x - x - y, from.y - y + x),
            ),
        )
    }
