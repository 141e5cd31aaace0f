package robotran.benchmarks

import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Shade
import robotran.world.Wall
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape

/**
 * A large sheet with this many barriers, blocks and robots, none of which overlap at the start. The barriers are in
 * rows, the robots in the free strips between them.
 */
internal fun crowdedWorld(barriers: Int, robots: Int, blocks: Int = 0, furnished: Boolean = false): World =
    BuiltInWorlds.plain.copy(
        title = "$barriers barriers, $robots robots",
        paper = Paper(SIDE, SIDE),
        walls = walls(),
        robots = List(robots) { robotAt(it, if (furnished && it % 2 == 1) LightFacing.FORWARD else LightFacing.DOWN) },
        barriers = List(barriers) { Barrier(barrierAt(it)) },
        blocks = List(blocks) { MovableBlock(Shape.Circle(Point(60.0 + 30 * it, 48.0 + 80 * (it % 3)), 3.0)) },
        marks = if (furnished) listOf(ring()) else emptyList(),
        lamps = if (furnished) listOf(Lamp(Point(100.0, 200.0)), Lamp(Point(300.0, 40.0))) else emptyList(),
        realism = if (furnished) 0.5 else 0.0,
    )

private fun walls(): List<Wall> {
    val corners = listOf(Point(0.0, 0.0), Point(SIDE, 0.0), Point(SIDE, SIDE), Point(0.0, SIDE))
    return corners.indices.map { Wall(corners[it], corners[(it + 1) % corners.size], 1.0) }
}

private fun robotAt(number: Int, facing: LightFacing) = RobotPlacement(
    Pose(30.0 + 45 * (number % 4), 50.0 + 80 * (number / 4), 20.0 * number),
    name = "robot $number",
    lightFacing = facing,
)

private fun barrierAt(number: Int): Shape {
    val x = 10.0 + 9.5 * (number % PER_ROW)
    val y = ROWS[number / PER_ROW % ROWS.size] + 3.0 * (number / PER_ROW / ROWS.size)
    return if (number % 2 == 0) {
        Shape.Rectangle(Point(x, y), 4.0, 2.0, 10.0 * number)
    } else {
        Shape.Circle(Point(x, y), 1.0)
    }
}

private fun ring(): Mark {
    val corners = listOf(Point(40.0, 40.0), Point(200.0, 60.0), Point(120.0, 220.0))
    return Mark(MarkFigure.Line(corners, width = 2.0, closed = true), Shade.Grey(0.1))
}

private const val SIDE = 400.0
private const val PER_ROW = 40

/** The positions of the barrier rows; robots fit between them. */
private val ROWS = listOf(15.0, 95.0, 175.0, 255.0, 335.0)
