package robotran.scene3d

import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.scene3d.geometry.Vector3
import robotran.scene3d.model.Heights
import robotran.scene3d.model.SceneNode
import robotran.world.Barrier
import robotran.world.Facing
import robotran.world.Lamp
import robotran.world.MovableBlock
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.Wall
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.penbotPorts
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The order of drawing needs convex bodies that stand where their footprints say. */
class BodyTest {
    private val world = World(
        "Bodies",
        Paper(100.0, 80.0),
        listOf(RobotPlacement(Pose(20.0, 20.0, 30.0)), RobotPlacement(Pose(60.0, 20.0, 30.0), "red", beacon = 1.0)),
        walls = listOf(
            // Without length.
            Wall(Point(5.0, 5.0), Point(5.0, 5.0), 2.0),
            Wall(Point(0.0, 60.0), Point(50.0, 70.0), 2.0),
            Wall(Point(20.0, 50.0), Point(20.0, 80.0), 2.0),
        ),
        barriers = listOf(
            Barrier(Shape.Circle(Point(80.0, 60.0), 5.0)),
            // Concave and clockwise.
            Barrier(Shape.Polygon(listOf(Point(90.0, 10.0), Point(90.0, 30.0), Point(94.0, 16.0), Point(99.0, 10.0)))),
        ),
        blocks = listOf(MovableBlock(Shape.Rectangle(Point(70.0, 40.0), 6.0, 3.0, 20.0))),
        lamps = listOf(Lamp(Point(40.0, 40.0)), Lamp(Point(50.0, 40.0), direction = 40.0, cone = 60.0)),
    )
    private val scene = SceneBuilder(world, TEST_COLOURS, TestTrigonometry)
        .scene(restingState(world), listOf(FlagPlace(Point(10.0, 70.0), met = false)))
    private val solids = solidsOf(scene.root)

    @Test
    fun `all corners of a body are on the inner side of all its faces`() {
        for (solid in solids) {
            val corners = solid.body.faces.flatMap { face -> cornersOf(face.corners) }
            for (face in solid.body.faces) {
                for (corner in corners) assertTrue(face.distanceTo(corner) < 1e-6, "${solid.element}: $corner")
            }
        }
    }

    @Test
    fun `a grid of as many crossing walls as a world may have stays small`() {
        val walls = List(100) { Wall(Point(0.0, it * 0.7), Point(99.0, it * 0.7), 0.3) } +
            List(100) { Wall(Point(it * 0.9, 0.0), Point(it * 0.9, 79.0), 0.3) }
        val grid = world.copy(walls = walls, barriers = emptyList())
        val root = SceneBuilder(grid, TEST_COLOURS, TestTrigonometry).scene(restingState(grid), emptyList()).root
        assertTrue(solidsOf(root).size in 200..2_000, "${solidsOf(root).size} solids")
    }

    @Test
    fun `a footprint covers all of its body`() {
        for (solid in solids) {
            val polygon = solid.body.footprint
            for (corner in solid.body.faces.flatMap { cornersOf(it.corners) }) {
                for (edge in 0 until polygon.size) {
                    val next = (edge + 1) % polygon.size
                    val alongX = polygon.x(next) - polygon.x(edge)
                    val alongY = polygon.y(next) - polygon.y(edge)
                    val inwards = alongX * (corner.y - polygon.y(edge)) - alongY * (corner.x - polygon.x(edge))
                    assertTrue(inwards > -1e-6, "${solid.element}: $corner")
                }
            }
        }
    }

    @Test
    fun `parts side by side do not overlap, also while a bumper is pressed`() {
        val pressed = restingState(world).let { state ->
            state.copy(
                robots = state.robots.map {
                    it.copy(robot = it.robot.copy(leftBumperPressed = true, rightBumperPressed = true, penDepth = 0.3))
                },
            )
        }
        for (moment in listOf(restingState(world), pressed)) {
            checkGroups(SceneBuilder(world, TEST_COLOURS, TestTrigonometry).scene(moment).root)
        }
    }

    @Test
    fun `the parts of all ready robots are convex and do not overlap, and each has its sensors`() {
        for ((name, robot) in ReadyRobots.all) {
            for (turned in listOf(false, true)) {
                val description = robot.copy(brickAt = robot.brickAt.copy(turned = turned))
                val place = RobotPlacement(Pose(40.0, 40.0, 30.0), description = description, beacon = 1.0)
                val one = World(name, Paper(100.0, 80.0), listOf(place))
                for (pressed in listOf(emptySet(), setOf(0, 1))) {
                    val state = restingState(one).let { state ->
                        state.copy(robots = state.robots.map { it.copy(robot = it.robot.copy(pressed = pressed)) })
                    }
                    val root = SceneBuilder(one, TEST_COLOURS, TestTrigonometry).scene(state).root
                    checkGroups(root)
                    for (solid in solidsOf(root)) {
                        val corners = solid.body.faces.flatMap { face -> cornersOf(face.corners) }
                        for (face in solid.body.faces) {
                            for (corner in corners) assertTrue(face.distanceTo(corner) < 1e-6, "$name: $corner")
                        }
                        assertTrue(solid.body.top <= Heights.STANDING, name)
                    }
                }
                if (description.penbotPorts != null) continue
                val model = SceneBuilder(one, TEST_COLOURS, TestTrigonometry).scene(restingState(one)).root
                val grey = solidsOf(model).count { it.body.bottom in SENSOR_BOTTOMS }
                assertTrue(grey >= description.parts.count { it is SensorPart }, "$name: $grey sensors")
            }
        }
    }

    @Test
    fun `a turret turns its sensor, which has room wherever it looks`() {
        val sonar = SensorPart(4, SensorKind.ULTRASONIC, Point(0.0, 0.0), 10.0, Facing.Ahead(0.0), MotorPort.B)
        val robot = ReadyRobots.NXT_PENBOT.copy(pen = null, parts = listOf(sonar), base = null)
        val place = RobotPlacement(Pose(40.0, 40.0, 30.0), description = robot, beacon = 0.0)
        val one = World("Turret", Paper(100.0, 80.0), listOf(place))
        val looks = listOf(0.0, 45.0, 90.0, 130.0, 180.0, -100.0).map { turret ->
            val state = restingState(one).let { state ->
                state.copy(robots = state.robots.map { it.copy(robot = it.robot.copy(turret = turret)) })
            }
            val root = SceneBuilder(one, TEST_COLOURS, TestTrigonometry).scene(state).root
            checkGroups(root)
            solidsOf(root).single { it.body.bottom == ON_BRICK && it.body.faces.any { face -> face.decals.size == 4 } }
        }
        for ((solid, degrees) in looks.zip(listOf(30.0, 75.0, 120.0, 160.0, 210.0, -70.0))) {
            assertEquals(cos(degrees * PI / 180), solid.place.cosine, 1e-6)
            assertEquals(sin(degrees * PI / 180), solid.place.sine, 1e-6)
        }
    }

    private fun checkGroups(node: SceneNode) {
        when (node) {
            is SceneNode.Solid -> Unit
            is SceneNode.Stack -> node.levels.forEach(::checkGroups)

            is SceneNode.Group -> {
                node.parts.forEach(::checkGroups)
                for (one in node.parts) {
                    for (other in node.parts) {
                        if (one === other) continue
                        var left: robotran.scene3d.geometry.ConvexPolygon? = one.footprint
                        for (edge in 0 until other.footprint.size) {
                            val next = (edge + 1) % other.footprint.size
                            val normalX = other.footprint.y(edge) - other.footprint.y(next)
                            val normalY = other.footprint.x(next) - other.footprint.x(edge)
                            val offset = normalX * other.footprint.x(edge) + normalY * other.footprint.y(edge)
                            left = left?.beyond(normalX, normalY, offset)
                        }
                        val area = left?.let { robotran.world.geometry.signedArea(it.corners) } ?: 0.0
                        assertTrue(area < 1e-4, "$area of ${one.footprint.corners} and ${other.footprint.corners}")
                    }
                }
            }
        }
    }

    private fun cornersOf(corners: DoubleArray) =
        List(corners.size / 3) { Vector3(corners[3 * it], corners[3 * it + 1], corners[3 * it + 2]) }

    private fun solidsOf(node: SceneNode): List<SceneNode.Solid> = when (node) {
        is SceneNode.Solid -> listOf(node)
        is SceneNode.Group -> node.parts.flatMap { solidsOf(it) }
        is SceneNode.Stack -> node.levels.flatMap { solidsOf(it) }
    }

    private companion object {
        const val ON_BRICK = 8.0

        /** Of a low sensor, one on the chassis and one on the brick. */
        val SENSOR_BOTTOMS = listOf(0.35, 4.6, ON_BRICK)
    }
}
