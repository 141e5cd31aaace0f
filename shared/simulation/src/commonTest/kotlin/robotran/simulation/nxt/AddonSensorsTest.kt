package robotran.simulation.nxt

import kotlinx.coroutines.test.runTest
import robotran.brick.program.BrickProgram
import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.SensorType
import robotran.simulation.MessageProgram
import robotran.simulation.Session
import robotran.world.Barrier
import robotran.world.BumperSide
import robotran.world.Facing
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.ReadyRobots
import robotran.world.RobotPart
import robotran.world.RobotPlacement
import robotran.world.RotationPart
import robotran.world.SensorPart
import robotran.world.Shade
import robotran.world.World
import robotran.world.geometry.Direction
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** What sensors of other makers, and those of an RCX, tell a program for an NXT. */
class AddonSensorsTest {
    private fun world(vararg parts: RobotPart) = openWorld(ReadyRobots.NXT_PENBOT.copy(parts = parts.toList()))

    private fun down(port: Int, kind: SensorKind) = SensorPart(port, kind, Point(7.2, 0.0), 1.0, Facing.Down)

    private fun ahead(port: Int, kind: SensorKind) = SensorPart(port, kind, Point(7.2, 0.0), 6.0, Facing.Ahead(0.0))

    private fun World.painted(shade: Shade) =
        copy(marks = listOf(Mark(MarkFigure.Area(Shape.Circle(Point(307.2, 300.0), 5.0)), shade)))

    private suspend fun shown(world: World, program: String, milliseconds: Int): Pair<List<String>, Session> {
        val session = nxtSession(world, nxj(program))
        session.advance(milliseconds)
        return session.state.brick.screen.lines.map { it.trimEnd() }.filter { it.isNotEmpty() } to session
    }

    private val makers = world(
        down(1, SensorKind.HITECHNIC_COLOUR),
        ahead(2, SensorKind.MINDSENSORS_COMPASS),
        ahead(3, SensorKind.MINDSENSORS_ACCELERATION),
        ahead(4, SensorKind.OPTICAL_DISTANCE),
    )

    @Test
    fun `sensors of HiTechnic and mindsensors tell what is around the robot`() = runTest(timeout = 3.minutes) {
        val wall = Barrier(Shape.Rectangle(Point(342.2, 300.0), 10.0, 60.0))
        val world = makers.painted(Shade.Colour(220, 30, 30)).copy(barriers = listOf(wall))
        val (lines, session) = shown(world, "MakersSensors", 2_000)
        val expected = listOf(
            "0 true",
            "0",
            "90.0",
            "0 1000",
            "0 90",
            "300 30.0",
            "Color mndsnsrs",
        )
        assertEquals(expected, lines)
        assertEquals(emptyList(), session.warnings.map { it.message })
        assertEquals(
            listOf(8, 90, 0, 300),
            session.state.brick.inputs.mapIndexed { port, input ->
                input.measured(world.robots[0].description.parts[port].kind)
            },
        )
        val turned = makers.copy(robots = makers.robots.map { it.copy(start = Pose(300.0, 300.0, 60.0)) })
        assertEquals(listOf("6 false", "0", "29.0"), shown(turned, "MakersSensors", 2_000).first.take(3))
        assertEquals("800 80.0", shown(turned, "MakersSensors", 2_000).first[5])
    }

    @Test
    fun `the colour sensor of HiTechnic tells colours apart`() = runTest(timeout = 3.minutes) {
        val shades = mapOf(
            Shade.Grey(0.95) to "6",
            Shade.Grey(0.05) to "7",
            Shade.Colour(30, 150, 50) to "1",
            Shade.Colour(30, 60, 200) to "2",
            Shade.Colour(250, 220, 40) to "3",
            Shade.Colour(250, 130, 30) to "5",
        )
        for ((shade, number) in shades) {
            val described = shown(makers.painted(shade), "MakersSensors", 1_000).first.first()
            assertEquals(number, described.substringBefore(' '), "$shade")
        }
    }

    @Test
    fun `a program is told which sensors of other makers are missing`() = runTest(timeout = 3.minutes) {
        val session = shown(openWorld(), "MakersSensors", 2_000).second
        val missing = session.state.missingSensors?.sensors?.map { it.port to it.kind }
        val expected = listOf(
            1 to SensorKind.HITECHNIC_COLOUR,
            2 to SensorKind.MINDSENSORS_COMPASS,
            3 to SensorKind.MINDSENSORS_ACCELERATION,
            4 to SensorKind.OPTICAL_DISTANCE,
        )
        assertEquals(expected, missing)
    }

    private val old = world(
        down(1, SensorKind.RCX_LIGHT),
        RotationPart(2, BumperSide.LEFT),
        ahead(3, SensorKind.NXT_TEMPERATURE),
        ahead(4, SensorKind.HITECHNIC_ACCELERATION),
    )

    @Test
    fun `sensors of an RCX, a thermometer and a push are felt`() = runTest(timeout = 3.minutes) {
        val (lines, session) = shown(old.copy(temperature = 21.4), "OldSensors", 4_000)
        val (light, warmth, rest, push, difference) = lines
        assertEquals("true", light.substringAfter(' '))
        assertTrue(light.substringBefore(' ').toInt() in 25..45, light)
        assertEquals("21.375", warmth)
        assertEquals("0 200", rest)
        assertTrue(push.toInt() in 10..200, push)
        assertTrue(difference.toInt() in -30..30, difference)
        assertEquals(emptyList(), session.warnings.map { it.message })
    }

    @Test
    fun `the app shows a thermometer and an axle of an RCX in degrees, whatever a program reads`() =
        runTest(timeout = 3.minutes) {
            val brick = shown(old, "OldSensors", 4_000).second.state.brick
            val turned = assertNotNull(brick.inputs[1].measured(SensorKind.ROTATION))
            assertTrue(turned > 360 && abs(turned - brick.motorDegrees[0]) < 30, "$turned")
            val warm = world(
                ahead(1, SensorKind.TEMPERATURE),
                RotationPart(2, BumperSide.LEFT),
            ).copy(temperature = 30.0)
            val inputs = nxtSession(warm, ScriptedNxt { pause(100) }).apply { advance(50) }.state.brick.inputs
            assertEquals(30, inputs[0].measured(SensorKind.TEMPERATURE))
            assertNull(inputs[1].measured(SensorKind.ROTATION), "it is off")
            assertTrue(inputs[0].value > 400, "a program reads what the pin measures")
        }

    @Test
    fun `realism makes the same sensors flicker`() = runTest(timeout = 3.minutes) {
        val real = old.copy(realism = 1.0, temperature = 21.4)
        val first = shown(real, "OldSensors", 4_000).first
        assertEquals(first, shown(real, "OldSensors", 4_000).first, "the same again with the same seed")
        assertTrue(first != shown(real.copy(seed = real.seed + 1), "OldSensors", 4_000).first)
    }

    private val seekers =
        world(ahead(1, SensorKind.INFRARED_SEEKER), ahead(2, SensorKind.INFRARED_SEEKER_2))

    /** A lamp 50 cm from the seekers, so many degrees to the left. */
    private fun lamp(degrees: Double, sends: Boolean): Lamp =
        Lamp(Direction(degrees).from(Point(307.2, 300.0), 50.0, 0.0), infrared = sends)

    @Test
    fun `infrared seekers tell where lamps are, and one which of them send`() = runTest(timeout = 3.minutes) {
        val both = seekers.copy(lamps = listOf(lamp(90.0, sends = true), lamp(-60.0, sends = false)))
        val (first, sent, values, all) = shown(both, "SeekLamp", 500).first
        assertTrue(first in listOf("2 true", "7 true"), first)
        assertEquals("2 -90.0", sent)
        assertEquals(listOf(true, true, false, false, false), values.split(' ').map { it.toInt() > 0 })
        assertEquals("true", all.substringAfter(' '))
        val directions = mapOf(120.0 to 1, 60.0 to 3, 30.0 to 4, 0.0 to 5, -30.0 to 6, -60.0 to 7, -120.0 to 9)
        for ((degrees, direction) in directions) {
            val one = seekers.copy(lamps = listOf(lamp(degrees, sends = true)))
            val described = shown(one, "SeekLamp", 500).first
            assertEquals("$direction", described[0].substringBefore(' '), "$degrees")
            assertEquals("$direction ${(direction - 5) * 30}.0", described[1])
        }
    }

    @Test
    fun `walls hide lamps that send and other sensors do not see them`() = runTest(timeout = 3.minutes) {
        val ahead = seekers.copy(lamps = listOf(lamp(0.0, sends = true)))
        val wall = Barrier(Shape.Rectangle(Point(330.0, 300.0), 4.0, 60.0))
        assertEquals("0 NaN", shown(ahead.copy(barriers = listOf(wall)), "SeekLamp", 500).first[1])
        val off = ahead.copy(lamps = ahead.lamps.map { it.copy(on = false) })
        assertEquals("0 NaN", shown(off, "SeekLamp", 500).first[1])
        val eye = world(ahead(1, SensorKind.LIGHT)).copy(lamps = ahead.lamps)
        val lit = ScriptedNxt {
            sensor(1, SensorType.LIGHT_INACTIVE)
            pause(100_000)
        }
        val values = listOf(eye, eye.copy(lamps = emptyList())).map { world ->
            nxtSession(world, lit).apply { advance(100) }.state.brick.inputs[0].value
        }
        assertEquals(values[1], values[0])
    }

    private suspend fun called(away: Double, program: BrickProgram?): Session {
        val link = world(ahead(1, SensorKind.RCX_LINK))
        val rcx = RobotPlacement(Pose(300.0 + away, 270.0, 0.0), name = "red")
        val pair = link.copy(robots = link.robots + rcx)
        return nxtSession(pair, *listOfNotNull(nxj("CallRcx"), program).toTypedArray()).apply { advance(2_000) }
    }

    private fun Session.lines() = state.brick.screen.lines.map { it.trimEnd() }.filter { it.isNotEmpty() }

    @Test
    fun `an RCX in its menu answers the link of an NXT`() = runTest(timeout = 3.minutes) {
        val near = called(away = 0.0, program = null)
        assertEquals(listOf("7", "239 16 239 16 0"), near.lines())
        assertEquals(emptyList(), near.warnings.map { it.message })
        assertEquals(listOf("0", "0"), called(away = 150.0, program = null).lines(), "the light does not go so far")
    }

    @Test
    fun `the program of an RCX hears the link of an NXT`() = runTest(timeout = 3.minutes) {
        for ((away, hears) in listOf(0.0 to true, 150.0 to false)) {
            val program = MessageProgram(sends = emptyList())
            called(away, program)
            assertEquals(hears, program.hasHeard, "$away")
        }
    }
}
