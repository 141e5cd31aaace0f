package robotran.simulation.nxt

import kotlinx.coroutines.test.runTest
import robotran.brick.sensors.SensorKind
import robotran.nxt.hardware.ColourKind
import robotran.nxt.hardware.I2cMode
import robotran.nxt.hardware.SensorType
import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import robotran.nxt.state.NxtState
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.world.Barrier
import robotran.world.BumperPart
import robotran.world.Facing
import robotran.world.FingerTouchPart
import robotran.world.Lamp
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.ReadyRobots
import robotran.world.RobotPart
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.Shade
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** What the sensors of an NXT measure of the world around it. */
class NxtSensorsTest {
    private fun world(vararg parts: RobotPart) = openWorld(ReadyRobots.NXT_PENBOT.copy(parts = parts.toList()))

    private fun sensor(kind: SensorKind, facing: Facing = Facing.Down) =
        SensorPart(1, kind, Point(7.2, 0.0), if (facing == Facing.Down) 1.0 else 6.0, facing)

    private fun using(type: Int) = ScriptedNxt {
        sensor(1, type)
        pause(100_000)
    }

    private fun Session.value(port: Int = 1): Int = state.brick.inputs[port - 1].value

    private suspend fun value(world: World, type: Int, milliseconds: Int = 200): Int {
        val session = nxtSession(world, using(type))
        session.advance(milliseconds)
        return session.value().also { session.close() }
    }

    private fun World.painted(shade: Shade) =
        copy(marks = listOf(Mark(MarkFigure.Area(Shape.Circle(Point(307.2, 300.0), 5.0)), shade)))

    @Test
    fun `the light sensor tells the percentages that pupils have measured`() = runTest {
        val world = world(sensor(SensorKind.LIGHT))
        assertEquals(58, value(world, SensorType.LIGHT_ACTIVE))
        assertEquals(32, value(world.painted(Shade.Grey(0.12)), SensorType.LIGHT_ACTIVE))
        val red = value(world.painted(Shade.Colour(230, 30, 30)), SensorType.LIGHT_ACTIVE)
        assertTrue(red in 50..56, "$red")
        val blue = value(world.painted(Shade.Colour(30, 60, 220)), SensorType.LIGHT_ACTIVE)
        assertTrue(blue in 32..41, "$blue")
        val byDay = world.copy(ambientLight = 2.0)
        assertEquals(30, value(byDay, SensorType.LIGHT_INACTIVE), "by day without lamp")
        assertTrue(value(byDay.painted(Shade.Grey(0.12)), SensorType.LIGHT_INACTIVE) in 16..17)
    }

    @Test
    fun `ahead it sees the light of the room and lamps`() = runTest {
        val ahead = world(sensor(SensorKind.LIGHT, Facing.Ahead(0.0)))
        assertTrue(value(ahead, SensorType.LIGHT_INACTIVE) in 20..30)
        assertTrue(value(ahead.copy(ambientLight = 2.0), SensorType.LIGHT_INACTIVE) in 45..60)
        val torch = ahead.copy(lamps = listOf(Lamp(Point(337.2, 300.0), brightness = 4.0)))
        assertTrue(value(torch, SensorType.LIGHT_INACTIVE) in 58..75)
        val behind = ahead.copy(lamps = listOf(Lamp(Point(260.0, 300.0), brightness = 4.0)))
        assertTrue(value(behind, SensorType.LIGHT_INACTIVE) in 20..30)
    }

    @Test
    fun `the colour sensor tells six colours apart`() = runTest {
        val world = world(sensor(SensorKind.COLOUR))
        val shades = mapOf(
            Shade.Grey(0.95) to ColourKind.WHITE,
            Shade.Grey(0.05) to ColourKind.BLACK,
            Shade.Colour(220, 30, 30) to ColourKind.RED,
            Shade.Colour(30, 150, 50) to ColourKind.GREEN,
            Shade.Colour(30, 60, 200) to ColourKind.BLUE,
            Shade.Colour(250, 220, 40) to ColourKind.YELLOW,
        )
        for ((shade, kind) in shades) {
            assertEquals(kind.code, value(world.painted(shade), SensorType.COLOUR_FULL), "$shade")
            assertEquals(kind.code, value(world.painted(shade).copy(realism = 1.0), SensorType.COLOUR_FULL), "$shade")
        }
        val high = sensor(SensorKind.COLOUR).copy(height = 3.0)
        assertEquals(ColourKind.BLACK.code, value(world(high), SensorType.COLOUR_FULL))
    }

    @Test
    fun `bumpers and fingers press touch sensors`() = runTest {
        val bumper = BumperPart(1, Point(9.4, 0.0), width = 8.0)
        val world = world(bumper, FingerTouchPart(2))
        val session = nxtSession(
            world.copy(barriers = listOf(Barrier(Shape.Rectangle(Point(330.0, 300.0), 20.0, 60.0)))),
            ScriptedNxt {
                sensor(1, SensorType.SWITCH)
                sensor(2, SensorType.SWITCH)
                motors(60)
                pause(100_000)
            },
        )
        session.advance(100)
        assertEquals(listOf(0, 0), listOf(session.value(1), session.value(2)))
        session.apply(SessionInput.TouchSensor(0, 1, true))
        session.advance(5)
        assertEquals(1, session.value(2))
        session.advance(2_000)
        assertEquals(1, session.value(1))
        assertEquals(setOf(0), session.state.robot.pressed)
        session.apply(SessionInput.TouchSensor(0, 1, false))
        session.advance(5)
        assertEquals(0, session.value(2))
    }

    @Test
    fun `the sound sensor hears loudspeakers`() = runTest {
        val sounding = ScriptedNxt {
            pause(1_000)
            call(NxtCall.of(NxtNative.PLAY_FREQ, 440, 1_000, 100))
            pause(100_000)
        }
        val near = RobotPlacement(Pose(340.0, 300.0, 0.0), name = "red", description = ReadyRobots.NXT_PENBOT)
        val world = world(sensor(SensorKind.SOUND, Facing.Ahead(0.0)))
        val session = nxtSession(world.copy(robots = world.robots + near), using(SensorType.SOUND_DB), sounding)
        session.advance(900)
        assertTrue(session.value() in 3..4)
        session.advance(500)
        assertTrue(session.value() in 7..12, "${session.value()}")
        session.advance(1_000)
        assertTrue(session.value() in 3..4)
        val own = ScriptedNxt {
            sensor(1, SensorType.SOUND_DB)
            call(NxtCall.of(NxtNative.PLAY_FREQ, 440, 1_000, 100))
            pause(100_000)
        }
        val alone = nxtSession(world, own)
        alone.advance(500)
        assertTrue(alone.value() > 60)
    }

    @Test
    fun `a gyro tells how fast the robot turns and a compass where it looks`() = runTest {
        val world = world(
            sensor(SensorKind.GYRO, Facing.Ahead(0.0)),
            sensor(SensorKind.COMPASS, Facing.Ahead(0.0)).copy(port = 2),
        )
        val session = nxtSession(
            world,
            ScriptedNxt {
                sensor(1, SensorType.CUSTOM)
                sensor(2, SensorType.LOWSPEED)
                call(NxtCall.of(NxtNative.I2C_ENABLE, 1, I2cMode.LEGO))
                call(NxtCall(NxtNative.I2C_START, intArrayOf(1, 2, 2), bytes = byteArrayOf(0x42)))
                pause(100)
                motors(-30, 30)
                pause(100_000)
            },
        )
        session.advance(20)
        val resting = session.value(1)
        assertEquals(90, session.value(2))
        session.advance(1_000)
        val before = session.state.robot.pose.heading
        session.advance(100)
        val perSecond = (session.state.robot.pose.heading - before) * 10
        assertEquals(600, resting)
        assertEquals(600 - perSecond, session.value(1).toDouble(), 2.0)
        assertEquals((90 - session.state.robot.pose.heading).mod(360.0), session.value(2).toDouble(), 1.0)
        assertEquals(emptyList(), session.warnings.map { it.message })
    }

    @Test
    fun `batteries sag under load and the brick measures it`() = runTest {
        val driving = ScriptedNxt {
            pause(100)
            motors(100)
            pause(100_000)
        }
        val real = nxtSession(openWorld().copy(realism = 1.0), driving)
        real.advance(50)
        val fresh = real.state.brick.batteryMillivolts
        real.advance(3_000)
        val driven = real.state.brick.batteryMillivolts
        assertTrue(driven in 7_000..<fresh, "$fresh, then $driven")
        val ideal = nxtSession(openWorld(), driving)
        ideal.advance(3_000)
        assertTrue(ideal.state.brick.batteryMillivolts in 7_990..8_010)
    }

    @Test
    fun `a program is told which sensor is missing`() = runTest {
        val session = nxtSession(world(sensor(SensorKind.LIGHT)), using(SensorType.SOUND_DB))
        session.advance(50)
        assertEquals(listOf(SensorKind.SOUND), session.state.missingSensors?.sensors?.map { it.kind })
        assertTrue(session.state.brick is NxtState)
    }
}
