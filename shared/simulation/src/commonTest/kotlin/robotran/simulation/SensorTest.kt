package robotran.simulation

import kotlinx.coroutines.test.runTest
import robotran.rcxrom.sensors.TouchSensor
import robotran.rcxrom.state.RcxState
import robotran.simulation.state.LampState
import robotran.world.Barrier
import robotran.world.Lamp
import robotran.world.LightFacing
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.Paper
import robotran.world.Penbot
import robotran.world.PortSensor
import robotran.world.Shade
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class SensorTest {
    private val sheet = BuiltInWorlds.plain.copy(walls = emptyList()).withStart(Pose(50.0, 40.0, 0.0))

    private val lightIsOn = ScriptedProgram {
        activate(port = 1)
        pause(100_000)
    }

    private fun World.with(facing: LightFacing) = copy(robots = robots.map { it.copy(lightFacing = facing) })

    /** The value of the light sensor after a moment. */
    private suspend fun light(world: World, program: ScriptedProgram = lightIsOn): Int {
        val session = startRun(program, world)
        session.advance(50)
        return session.raw(2)
    }

    private fun Session.raw(port: Int, robot: Int = 0) = (state.robots[robot].brick as RcxState).sensors[port - 1].raw

    /** A spot under the light sensor of a robot at the sheet's start. */
    private fun spot(size: Double, shade: Shade) =
        Mark(MarkFigure.Area(Shape.Rectangle(Point(50.0 + Penbot.LIGHT_SENSOR_POSITION, 40.0), size, size)), shade)

    @Test
    fun `a bumper that is hit is measured on its port and no other`() = runTest {
        val program = ScriptedProgram {
            motors(ScriptedProgram.FORWARD, 3)
            pause(3_000)
        }
        val block = Barrier(Shape.Rectangle(Point(80.0, 43.5), 4.0, 5.0))
        val session = startRun(program, sheet.copy(barriers = listOf(block)))
        assertEquals(1023, session.raw(1))
        session.advance(1_500)
        assertEquals(TouchSensor.PRESSED_RAW, session.raw(1))
        assertEquals(1023, session.raw(3))
        assertEquals(setOf(TouchKind.BARRIERS), session.state.robot.touching)
    }

    @Test
    fun `white paper is light, a black mark is dark, and grey is in between`() = runTest {
        val white = light(sheet)
        val grey = light(sheet.copy(marks = listOf(spot(3.0, Shade.Grey(0.4)))))
        val black = light(sheet.copy(marks = listOf(spot(3.0, Shade.Grey(0.0)))))
        assertEquals(listOf(697, 754, 813), listOf(white, grey, black))
    }

    @Test
    fun `the upper of two marks is seen`() = runTest {
        val dark = spot(3.0, Shade.Grey(0.0))
        val bright = spot(2.0, Shade.Grey(0.9))
        assertEquals(light(sheet), light(sheet.copy(marks = listOf(dark, bright))))
        assertEquals(light(sheet.copy(marks = listOf(dark))), light(sheet.copy(marks = listOf(bright, dark))))
    }

    @Test
    fun `red is bright to a red lamp and blue is dark`() = runTest {
        val red = light(sheet.copy(marks = listOf(spot(3.0, Shade.Colour(255, 40, 40)))))
        val blue = light(sheet.copy(marks = listOf(spot(3.0, Shade.Colour(40, 40, 255)))))
        assertTrue(red < 730 && blue > 780, "red $red, blue $blue")
    }

    @Test
    fun `at an edge the spot is averaged`() = runTest {
        val half =
            Mark(
                MarkFigure.Area(Shape.Rectangle(Point(50.0 + Penbot.LIGHT_SENSOR_POSITION + 1.5, 40.0), 3.0, 3.0)),
                Shade.Grey(0.0),
            )
        val white = light(sheet)
        val black = light(sheet.copy(marks = listOf(spot(3.0, Shade.Grey(0.0)))))
        val between = light(sheet.copy(marks = listOf(half)))
        assertTrue(between in white + 30..black - 30, "$white $between $black")
    }

    @Test
    fun `a line, a grey map and the floor beside the paper are seen`() = runTest {
        val x = 50.0 + Penbot.LIGHT_SENSOR_POSITION
        val line = Mark(MarkFigure.Line(listOf(Point(x, 0.0), Point(x, 80.0)), width = 2.0))
        val map = Mark(MarkFigure.GreyMap(Point(x - 2, 37.0), 2.0, listOf("ff", "..", "00")))
        assertEquals(813, light(sheet.copy(marks = listOf(line))))
        assertEquals(697, light(sheet.copy(marks = listOf(map))))
        assertEquals(
            813,
            light(sheet.copy(marks = listOf(Mark(MarkFigure.GreyMap(Point(x - 2, 38.0), 2.0, listOf("00", "00")))))),
        )
        assertTrue(light(sheet.withStart(Pose(98.0, 40.0, 0.0))) > 750)
    }

    @Test
    fun `the robot sees its own ink`() = runTest {
        val program = ScriptedProgram {
            activate(port = 1)
            penDown()
            backward(20.0)
            forward(1.0)
            pause(10_000)
        }
        val session = startRun(program, sheet)
        session.advance(300)
        val white = session.raw(2)
        session.advance(1_800)
        assertTrue(session.raw(2) > white + 25, "white $white, ink ${session.raw(2)}")
    }

    @Test
    fun `without its lamp the sensor sees next to nothing of the paper`() = runTest {
        assertTrue(light(sheet, ScriptedProgram { pause(1_000) }) > 1000)
    }

    @Test
    fun `a dim room is about 850 and a lamp is brighter the nearer it is`() = runTest {
        val ahead = sheet.with(LightFacing.FORWARD)
        val lamps = listOf(80.0, 40.0, 20.0, 8.0).map { distance ->
            light(ahead.copy(lamps = listOf(Lamp(Point(50.0 + Penbot.LIGHT_SENSOR_POSITION + distance, 40.0)))))
        }
        assertEquals(856, light(ahead))
        assertEquals(lamps.sortedDescending(), lamps)
        assertTrue(lamps.first() < 856 && lamps.last() < 400, lamps.toString())
    }

    @Test
    fun `a lamp behind, one that is off, one that shines away and one behind a barrier are not seen`() = runTest {
        val ahead = sheet.with(LightFacing.FORWARD)
        val dark = light(ahead)
        val lamp = Lamp(Point(90.0, 40.0))
        assertEquals(dark, light(ahead.copy(lamps = listOf(lamp.copy(place = Point(20.0, 40.0))))))
        assertEquals(dark, light(ahead.copy(lamps = listOf(lamp.copy(on = false)))))
        assertEquals(dark, light(ahead.copy(lamps = listOf(lamp.copy(direction = 0.0, cone = 60.0)))))
        assertTrue(light(ahead.copy(lamps = listOf(lamp.copy(direction = 180.0, cone = 60.0)))) < dark - 50)
        // Too far away to reflect the sensor's own light.
        val wide = ahead.copy(paper = Paper(200.0, 80.0))
        val farLamp = lamp.copy(place = Point(100.0, 40.0), brightness = 4.0)
        val barrier = Barrier(Shape.Circle(Point(90.0, 40.0), 3.0))
        assertTrue(light(wide.copy(lamps = listOf(farLamp))) < dark - 50)
        assertEquals(dark, light(wide.copy(lamps = listOf(farLamp), barriers = listOf(barrier))))
    }

    @Test
    fun `something close ahead sends the sensor's own light back`() = runTest {
        val ahead = sheet.with(LightFacing.FORWARD)

        fun at(distance: Double) =
            listOf(Barrier(Shape.Rectangle(Point(50.0 + Penbot.LIGHT_SENSOR_POSITION + distance + 2, 40.0), 4.0, 20.0)))
        val near = light(ahead.copy(barriers = at(5.0)))
        val far = light(ahead.copy(barriers = at(15.0)))
        assertTrue(near < far && far < light(ahead), "near $near, far $far")
    }

    @Test
    fun `lamps can be moved and switched while it runs`() = runTest {
        val session = startRun(lightIsOn, sheet.with(LightFacing.FORWARD).copy(lamps = listOf(Lamp(Point(10.0, 40.0)))))
        session.advance(50)
        assertEquals(856, session.raw(2))
        session.apply(SessionInput.MoveLamp(0, Point(80.0, 40.0)))
        session.advance(5)
        assertTrue(session.raw(2) < 800)
        session.apply(SessionInput.SwitchLamp(0, on = false))
        session.advance(5)
        assertEquals(856, session.raw(2))
        session.apply(SessionInput.ChangeAmbientLight(2.0))
        session.advance(5)
        assertEquals(541, session.raw(2))
        assertEquals(listOf(LampState(Point(80.0, 40.0), on = false)), session.state.lamps)
    }

    @Test
    fun `a rotation sensor counts sixteen a turn`() = runTest {
        val program = ScriptedProgram {
            activate(port = 0)
            forward(Penbot.WHEEL_CIRCUMFERENCE + 0.5)
        }
        val world = sheet.copy(
            robots = sheet.robots.map {
                it.withPorts(listOf(listOf(PortSensor.LEFT_ROTATION), emptyList(), emptyList()))
            },
        )
        val session = startRun(program, world)
        val seen = mutableListOf<Int>()
        repeat(1_000) {
            session.advance(1)
            if (seen.lastOrNull() != session.raw(1)) seen += session.raw(1)
        }
        assertEquals(17, seen.size, seen.toString())
        assertEquals(listOf(992, 864, 416, 640, 992), seen.take(5))
    }

    @Test
    fun `two sensors on a port give the lower value, a finger presses a touch sensor, and warmth is measured`() =
        runTest {
            val ports = listOf(listOf(PortSensor.TOUCH, PortSensor.LIGHT), listOf(PortSensor.TEMPERATURE), emptyList())
            val session =
                startRun(
                    ScriptedProgram {
                        pause(9_000)
                    },
                    sheet.copy(robots = sheet.robots.map { it.withPorts(ports) }, temperature = 25.0),
                )
            session.advance(10)
            val light = session.raw(1)
            session.apply(SessionInput.TouchSensor(robot = 0, port = 0, pressed = true))
            session.advance(3)
            assertTrue(light > 500)
            assertEquals(TouchSensor.PRESSED_RAW, session.raw(1))
            session.apply(SessionInput.TouchSensor(robot = 0, port = 0, pressed = false))
            session.advance(3)
            assertEquals(light, session.raw(1))
            val warm = session.raw(2)
            session.apply(SessionInput.ChangeTemperature(5.0))
            session.advance(3)
            assertTrue(session.raw(2) > warm)
            assertEquals(1023, session.raw(3))
        }
}
