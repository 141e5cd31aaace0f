package robotran.simulation.nxt

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.nxt.program.NxtCall
import robotran.world.Barrier
import robotran.world.Facing
import robotran.world.MovableBlock
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SonarTest {
    private val front = 300 + 8.4

    private val listening = ScriptedNxt {
        sonar(4)
        pause(100_000)
    }

    /** What the sonar on port 4 reads after each of [count] pings. */
    private suspend fun readings(world: World, count: Int = 1): List<Int> {
        val session = nxtSession(world, listening)
        session.advance(100)
        return List(count) {
            session.advance(50)
            session.state.brick.inputs[3].value
        }.also { session.close() }
    }

    private suspend fun reading(world: World): Int = readings(world).single()

    private fun World.withBarrier(shape: Shape) = copy(barriers = barriers + Barrier(shape))

    /** A board of [width] at a distance ahead, turned by [angle] from square. */
    private fun board(distance: Double, angle: Double = 0.0, width: Double = 80.0) =
        Shape.Rectangle(Point(front + distance + 0.01, 300.0), 0.02, width, angle)

    @Test
    fun `a wall is as far away as it is`() = runTest {
        for (distance in listOf(3, 5, 10, 30, 60, 100, 180, 250)) {
            val world = openWorld().withBarrier(board(distance.toDouble(), width = 200.0))
            assertEquals(distance, reading(world), "at $distance cm")
        }
    }

    @Test
    fun `nothing is 255`() = runTest {
        assertEquals(255, reading(openWorld()))
        assertEquals(255, reading(openWorld().withBarrier(board(262.0))))
    }

    @Test
    fun `a slanted wall sends the sound elsewhere`() = runTest {
        assertTrue(reading(openWorld().withBarrier(board(50.0, 40.0))) in 38..50)
        assertEquals(255, reading(openWorld().withBarrier(board(50.0, 60.0, width = 200.0))))
    }

    @Test
    fun `a thing is heard in the beam only`() = runTest {
        fun at(degrees: Double): World {
            val x = front + 50 * cos(degrees * PI / 180)
            val y = 300 + 50 * sin(degrees * PI / 180)
            return openWorld().withBarrier(Shape.Circle(Point(x, y), 2.0))
        }
        assertEquals(48, reading(at(10.0)))
        assertEquals(48, reading(at(-10.0)))
        assertEquals(255, reading(at(25.0)))
    }

    @Test
    fun `the corner of a slanted thing is heard in the middle of the beam`() = runTest {
        // Its sides are mirrors.
        val spike = Shape.Polygon(listOf(Point(front + 40, 300.0), Point(front + 60, 294.0), Point(front + 60, 306.0)))
        assertTrue(reading(openWorld().withBarrier(spike)) in 40..47)
    }

    @Test
    fun `soft things are heard from near only`() = runTest {
        fun soft(distance: Double, friction: Double) = openWorld().copy(
            blocks = listOf(
                MovableBlock(Shape.Rectangle(Point(front + distance + 10, 300.0), 20.0, 20.0), friction = friction),
            ),
        )
        assertEquals(100, reading(soft(100.0, 0.9)))
        assertEquals(255, reading(soft(170.0, 0.9)))
        assertEquals(170, reading(soft(170.0, 0.3)))
    }

    @Test
    fun `it hears a robot and not its own`() = runTest {
        val other = RobotPlacement(Pose(360.0, 300.0, 90.0), name = "red")
        val world = openWorld().let { it.copy(robots = it.robots + other) }
        val distance = reading(world)
        assertTrue(distance in 43..52, "$distance")
    }

    @Test
    fun `a real one is wrong as builders tell`() = runTest {
        val wall = openWorld().withBarrier(board(15.0)).copy(realism = 1.0)
        val near = readings(wall, 200)
        val heard = near.filter { it < 255 }
        assertTrue(heard.size in 190..200, "${heard.size} heard")
        assertTrue(heard.distinct().size > 2, "$heard")
        val far = readings(openWorld().withBarrier(board(185.0, width = 200.0)).copy(realism = 1.0), 200)
        assertTrue(far.count { it == 255 } in 60..180, "${far.count { it == 255 }} lost")
        val close = readings(openWorld().withBarrier(board(4.0)).copy(realism = 1.0), 200)
        assertTrue(close.count { it == 255 } in 40..120, "${close.count { it == 255 }} lost")
    }

    @Test
    fun `the same world gives the same readings`() = runTest {
        val world = openWorld().withBarrier(board(30.0)).copy(realism = 0.7)
        assertEquals(readings(world, 50), readings(world, 50))
    }

    @Test
    fun `two that look at each other disturb each other`() = runTest {
        val other = RobotPlacement(Pose(420.0, 300.0, 180.0), name = "red", description = ReadyRobots.NXT_PENBOT)
        val pair = openWorld().copy(realism = 1.0).let { it.copy(robots = it.robots + other) }

        suspend fun halves(vararg programs: ScriptedNxt): Int {
            val session = nxtSession(pair, *programs)
            session.advance(100)
            val values = List(200) {
                session.advance(50)
                session.state.brick.inputs[3].value
            }
            session.close()
            return values.count { it in 45..57 }
        }
        assertEquals(0, halves(listening))
        assertTrue(halves(listening, listening) > 40)
    }

    @Test
    fun `a sonar on a motor looks where it is turned`() = runTest {
        val robot = ReadyRobots.NXT_PENBOT.copy(
            pen = null,
            parts = listOf(
                SensorPart(4, SensorKind.ULTRASONIC, Point(5.0, 0.0), 12.0, Facing.Ahead(0.0), turret = MotorPort.B),
            ),
        )
        val turning = ScriptedNxt {
            sonar(4)
            pause(200)
            call(
                NxtCall.regulate(ScriptedNxt.B, 360f, 6000, 90, hold = true),
            )
            pause(100_000)
        }
        val world = openWorld(robot)
            .withBarrier(Shape.Rectangle(Point(305.0, 355.0), 80.0, 10.0))
            .withBarrier(Shape.Rectangle(Point(405.0, 300.0), 20.0, 100.0))
        val session = nxtSession(world, turning)
        session.advance(150)
        assertEquals(90, session.state.brick.inputs[3].value)
        session.advance(1_500)
        assertEquals(90.0, session.state.robot.turret, 1.5)
        assertEquals(50, session.state.brick.inputs[3].value)
    }
}
