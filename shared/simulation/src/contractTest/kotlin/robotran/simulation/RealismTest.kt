package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.simulation.explain.Cause
import robotran.simulation.noise.NoiseStream
import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import robotran.world.geometry.RADIANS_PER_DEGREE
import kotlin.math.abs
import kotlin.math.sqrt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotEquals
import kotlin.test.assertTrue

class RealismTest {
    private val open = BuiltInWorlds.plain.copy(walls = emptyList(), paper = Paper(200.0, 80.0))

    private fun world(realism: Double, seed: Int) = open.copy(realism = realism, seed = seed)

    private val metre = ScriptedProgram { forward(100.0) }

    private suspend fun endOf(realism: Double, seed: Int): Pose = runToEnd(metre, world(realism, seed)).state.robot.pose

    @Test
    fun `without realism the seed does not matter`() = runTest {
        assertEquals(endOf(0.0, 1), endOf(0.0, 2))
    }

    @Test
    fun `the same seed gives the same run and another one another`() = runTest {
        assertEquals(endOf(0.5, 1), endOf(0.5, 1))
        assertNotEquals(endOf(0.5, 1), endOf(0.5, 2))
    }

    @Test
    fun `the more realistic the world the further robots stray`() = runTest {
        val spread = listOf(0.0, 0.25, 0.5, 1.0).map { realism ->
            val ends = (1..20).map { endOf(realism, it) }
            sqrt(ends.sumOf { (it.y - 30) * (it.y - 30) } / ends.size)
        }
        assertEquals(spread.sorted(), spread)
        assertTrue(spread[0] < 0.01 && spread[3] in 5.0..40.0, spread.toString())
    }

    @Test
    fun `a stream is even, its normal numbers are as wide as they should be, and names make it another`() {
        val stream = NoiseStream(1, "a")
        val shares = List(10_000) { stream.share() }
        assertEquals(0.5, shares.average(), 0.01)
        assertTrue(shares.all { it >= 0 && it < 1 })
        val numbers = List(10_000) { stream.normal() }
        assertEquals(0.0, numbers.average(), 0.03)
        assertEquals(1.0, sqrt(numbers.sumOf { it * it } / numbers.size), 0.03)
        assertTrue(numbers.all { abs(it) < 3.5 })
        assertEquals(
            3,
            setOf(NoiseStream(1, "a").share(), NoiseStream(1, "b").share(), NoiseStream(2, "a").share()).size,
        )
        assertEquals(NoiseStream(7, "motor").normal(), NoiseStream(7, "motor").normal())
    }

    @Test
    fun `the first numbers of a stream are what they have always been`() {
        val stream = NoiseStream(42, "robot 0: left wheel: strength")
        assertEquals(listOf(0.2583089378043444, 0.3676981953915299, 0.5644446316350905), List(3) { stream.share() })
    }

    @Test
    fun `plugging in another sensor does not change how the wheels stray`() = runTest {
        suspend fun end(ports: List<List<PortSensor>>): Pose {
            val world = world(0.6, 5)
            return runToEnd(metre, world.copy(robots = world.robots.map { it.withPorts(ports) })).state.robot.pose
        }
        assertEquals(end(RobotPlacement.PENBOT_PORTS), end(List(3) { listOf(PortSensor.TEMPERATURE) }))
    }

    @Test
    fun `nothing is to be explained where nothing strays`() = runTest {
        assertEquals(emptyList(), runToEnd(metre, world(0.0, 1)).explain())
    }

    @Test
    fun `what has made a robot stray is told and adds up`() = runTest {
        val session = runToEnd(metre, world(1.0, 3))
        val described = session.explain().associateBy { it.cause }
        assertTrue(
            Cause.START_HEADING in described && Cause.BATTERY in described && Cause.SLIP in described &&
                Cause.LIGHT_BIAS in described,
            described.toString(),
        )
        assertTrue(described.values.all { it.robot == "yellow" && it.sentence.endsWith(".") })
        val turn =
            described.getValue(Cause.RIGHT_STRENGTH).amount - described.getValue(Cause.LEFT_STRENGTH).amount -
                (described[Cause.FLUTTER]?.amount ?: 0.0)
        val expected = described.getValue(Cause.START_HEADING).amount + turn / Penbot.WHEEL_TRACK / RADIANS_PER_DEGREE
        assertEquals(expected, session.state.robot.pose.heading, 4.0)
    }

    @Test
    fun `the sentences name what happened`() = runTest {
        assertEquals(
            listOf(
                "The robot was put down 0.2 cm beside its place.",
                "It looked 0.4 degrees too far to the left when it was put down.",
                "The left motor is 0.8 % too weak: its wheel rolled 0.8 cm less than it should.",
                "The right motor is 0.7 % too weak: its wheel rolled 0.6 cm less than it should.",
                "The motors' speeds flutter: one wheel rolled 0.1 cm more by that, which turned the robot 0.5 " +
                    "degrees to the left.",
                "The wheels slipped a little on the floor and lost 1.5 cm together.",
                "The batteries are down to 8.8 volts: each wheel rolled 2.4 cm less than with fresh ones.",
                "The light sensor measures 2.3 raw units too much, so everything looks darker to it than it is.",
                "The light sensor's readings flicker by about 1.0 raw units.",
            ),
            runToEnd(metre, world(0.5, 3)).explain().map { it.sentence },
        )
    }

    @Test
    fun `wheels that turn at a wall are told even without realism`() = runTest {
        val program = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, 7)
            pause(6_000)
        }
        assertEquals(listOf(Cause.SPIN), runToEnd(program).explain().map { it.cause })
    }

    @Test
    fun `batteries go down as the motors are driven, and the brick measures it`() = runTest {
        val session = runToEnd(metre, world(1.0, 3))
        assertTrue(
            session.state.brick.batteryMillivolts in 8_000..8_990,
            session.state.brick.batteryMillivolts.toString(),
        )
        assertTrue(runToEnd(metre, world(0.0, 3)).state.brick.batteryMillivolts > 8_990)
    }
}
