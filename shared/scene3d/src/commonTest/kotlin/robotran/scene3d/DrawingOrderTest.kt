package robotran.scene3d

import robotran.scene3d.camera.Projection
import robotran.scene3d.camera.ScreenPoint
import robotran.simulation.state.RobotState
import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.RobotPlacement
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.math.cos
import kotlin.math.hypot
import kotlin.math.sin
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Compares what is drawn last at a pixel with what a ray through it meets first. */
class DrawingOrderTest {
    @Test
    fun `at every pixel the nearest solid is drawn last`() {
        var compared = 0
        repeat(WORLDS) { seed ->
            val random = Random(seed)
            val world = crowdedWorld(random)
            val scene = SceneBuilder(world, TEST_COLOURS, TestTrigonometry).scene(moving(world, random))
            repeat(CAMERAS) {
                compared += compare(scene, cameraOver(world, random), random, "world $seed")
            }
        }
        assertTrue(compared > WORLDS * CAMERAS * SAMPLES / 12, "only $compared pixels show a solid")
    }

    @Test
    fun `the eye of a robot sees the nearest solid, too`() {
        var compared = 0
        repeat(WORLDS) { seed ->
            val random = Random(1000 + seed)
            val world = crowdedWorld(random)
            val state = moving(world, random)
            val scene = SceneBuilder(world, TEST_COLOURS, TestTrigonometry).scene(state, eyeOf = 0)
            compared += compare(scene, camerasOf().eyeOf(state.robot.pose), random, "world $seed")
        }
        assertTrue(compared > WORLDS * SAMPLES / 16, "only $compared pixels show a solid")
    }

    /** Returns the number of pixels that show a solid. */
    private fun compare(scene: Scene, projection: Projection, random: Random, where: String): Int {
        val polygons = drawnPolygons(scene, projection)
        var solids = 0
        repeat(SAMPLES) {
            val place = ScreenPoint(
                random.nextDouble(projection.size.width),
                random.nextDouble(projection.size.height),
            )
            if (polygons.any { polygon -> polygon.contours.any { isNearEdge(it, place) } }) return@repeat
            val drawn = polygons.lastOrNull { polygon -> polygon.contours.any { isIn(it, place) } }?.solid
            val met = solidAt(scene, projection, place)?.first
            assertEquals(
                met?.let { "${it.element} ${it.body.bottom}..${it.body.top}" },
                drawn?.let { "${it.element} ${it.body.bottom}..${it.body.top}" },
                "$where at $place from ${projection.view.eye}",
            )
            if (met != null) solids++
        }
        return solids
    }

    /** Closer to an edge than the width by which round sides are made larger, or than decals stick out. */
    private fun isNearEdge(points: FloatArray, position: ScreenPoint): Boolean = (0 until points.size / 2).any {
        val next = (it + 1) % (points.size / 2)
        robotran.world.geometry.distance(
            Point(position.x, position.y),
            Point(points[2 * it].toDouble(), points[2 * it + 1].toDouble()),
            Point(points[2 * next].toDouble(), points[2 * next + 1].toDouble()),
        ) < EDGE
    }

    private fun isIn(points: FloatArray, position: ScreenPoint): Boolean {
        var inside = false
        for (corner in 0 until points.size / 2) {
            val next = (corner + 1) % (points.size / 2)
            val y = points[2 * corner + 1]
            val nextY = points[2 * next + 1]
            if ((y > position.y) == (nextY > position.y)) continue
            val x = points[2 * corner] + (position.y - y) / (nextY - y) * (points[2 * next] - points[2 * corner])
            if (position.x < x) inside = !inside
        }
        return inside
    }

    private fun cameraOver(world: World, random: Random): Projection {
        val cameras = camerasOf(random.nextDouble(300.0, 1300.0), random.nextDouble(300.0, 900.0))
        return cameras.around(
            world.paper,
            Point(random.nextDouble(world.paper.width), random.nextDouble(world.paper.height)),
            random.nextDouble(360.0),
            random.nextDouble(8.0, 90.0),
            random.nextDouble(1.0, 6.0),
        )
    }

    /** Two robots with all their parts moved. */
    private fun moving(world: World, random: Random) = restingState(
        world,
        world.robots.map {
            RobotState(
                it.start,
                random.nextDouble(),
                random.nextDouble(),
                penDown = false,
                leftBumperPressed = random.nextBoolean(),
                rightBumperPressed = random.nextBoolean(),
                penDepth = random.nextDouble(),
            )
        },
        world.blocks.map { Pose(0.0, 0.0, random.nextDouble(360.0)) },
    )

    /** Walls in all directions that cross, barriers of all shapes, and things between which there is room. */
    private fun crowdedWorld(random: Random): World {
        val taken = mutableListOf<Pair<Point, Double>>()

        fun place(radius: Double): Point {
            while (true) {
                val point = Point(random.nextDouble(150.0), random.nextDouble(100.0))
                if (taken.all { (other, its) -> hypot(point.x - other.x, point.y - other.y) > radius + its }) {
                    taken += point to radius
                    return point
                }
            }
        }
        val robots = List(2) {
            RobotPlacement(
                place(11.7).let { Pose(it.x, it.y, random.nextDouble(360.0)) },
                "robot $it",
                beacon = it.toDouble(),
            )
        }
        val blocks = List(6) {
            val size = random.nextDouble(2.0, 6.0)
            val at = place(size)
            MovableBlock(if (it % 2 == 0) Shape.Circle(at, size * 0.7) else Shape.Rectangle(at, size, size * 0.8))
        }
        val walls = generateSequence {
            val from = Point(random.nextDouble(150.0), random.nextDouble(100.0))
            val angle = random.nextDouble(6.3)
            val length = random.nextDouble(5.0, 50.0)
            Wall(from, Point(from.x + length * cos(angle), from.y + length * sin(angle)), 1.0)
        }.filter { wall -> taken.all { (point, radius) -> wall.distanceTo(point) > radius + 1.5 } }.take(8).toList()
        val barriers = List(8) {
            val size = random.nextDouble(2.0, 5.0)
            val at = place(size * 1.5)
            Barrier(
                when (it % 3) {
                    0 -> Shape.Rectangle(at, size * 2, size, random.nextDouble(360.0))
                    1 -> Shape.Circle(at, size)
                    else -> star(at, size, random)
                },
            )
        }
        return World(
            "Crowded",
            Paper(150.0, 100.0),
            robots,
            walls = walls,
            barriers = barriers,
            blocks = blocks,
            lamps = List(2) { Lamp(place(3.0), direction = random.nextDouble(360.0), cone = 60.0 + 300.0 * it) },
        )
    }

    private fun Wall.distanceTo(point: Point) = robotran.world.geometry.distance(point, from, to)

    /** A polygon whose corners are near and far in turn: concave. */
    private fun star(at: Point, size: Double, random: Random) = Shape.Polygon(
        List(10) {
            val radius = if (it % 2 == 0) size * 1.4 else size * random.nextDouble(0.4, 1.2)
            Point(at.x + radius * cos(it * 0.6283), at.y + radius * sin(it * 0.6283))
        },
    )

    private companion object {
        const val WORLDS = 40
        const val CAMERAS = 12
        const val SAMPLES = 60
        const val EDGE = 0.7
    }
}
