package robotran.world.file

import robotran.json.JsonCursor
import robotran.world.RobotDescription
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Outline
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.box
import robotran.world.geometry.flat
import robotran.world.geometry.length
import robotran.world.geometry.overlap
import robotran.world.messages.reason
import robotran.world.robot.box

/** Rejects a robot that would start in an obstacle or in another robot. */
internal fun checkStarts(world: World, file: JsonCursor) {
    val starts = file.member("robots").items(1..Int.MAX_VALUE).map { it.member("start") }
    val robots = world.robots.map { outline(it.start, it.description) }
    val obstacles = obstacles(world)
    robots.forEachIndexed { number, robot ->
        obstacles.firstOrNull { overlap(robot, it.shape) }?.let { starts[number].refuse(reason { startsIn(it.what) }) }
        (0..<number).firstOrNull {
            overlap(robot, robots[it])
        }?.let { starts[number].refuse(reason { startsIn("robots[$it]") }) }
    }
}

/** Whether the robot with this number starts neither in an obstacle nor in another robot. */
fun hasRoomAtStart(world: World, robot: Int): Boolean {
    val outlines = world.robots.map { outline(it.start, it.description) }
    val own = outlines[robot]
    return obstacles(world).none { overlap(own, it.shape) } &&
        outlines.indices.none { it != robot && overlap(own, outlines[it]) }
}

/** @property what its path in the file, such as `walls[2]`. */
private class Obstacle(val what: String, val shape: Outline)

private fun obstacles(world: World): List<Obstacle> =
    world.walls.mapIndexed { number, wall -> Obstacle("walls[$number]", outline(wall)) } +
        world.barriers.mapIndexed { number, barrier -> Obstacle("barriers[$number]", flat(barrier.shape)) } +
        world.blocks.mapIndexed { number, block -> Obstacle("blocks[$number]", flat(block.shape)) }

/** The box around chassis, wheels and bumpers of a robot at [start]. */
fun outline(start: Pose, robot: RobotDescription): Outline {
    val box = robot.box
    return box(Point(start.x, start.y), Direction(start.heading), box.left..box.right, box.bottom..box.top)
}

/** The area of a wall, including its square ends. */
fun outline(wall: Wall): Outline {
    val alongX = wall.to.x - wall.from.x
    val alongY = wall.to.y - wall.from.y
    val length = length(alongX, alongY)
    val half = wall.thickness / 2
    val aheadX = if (length == 0.0) half else alongX / length * half
    val aheadY = if (length == 0.0) 0.0 else alongY / length * half
    return Outline.Angular(
        listOf(
            Point(wall.from.x - aheadX + aheadY, wall.from.y - aheadY - aheadX),
            Point(wall.to.x + aheadX + aheadY, wall.to.y + aheadY - aheadX),
            Point(wall.to.x + aheadX - aheadY, wall.to.y + aheadY + aheadX),
            Point(wall.from.x - aheadX - aheadY, wall.from.y - aheadY + aheadX),
        ),
    )
}
