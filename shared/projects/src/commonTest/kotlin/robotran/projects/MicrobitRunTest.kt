package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BuggyKind
import robotran.brick.kind.WheelTrim
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.Mark
import robotran.world.MarkFigure
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.math.abs
import kotlin.math.hypot
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Robolang on robots with a micro:bit, in the simulated world. */
class MicrobitRunTest {
    private suspend fun run(robot: RobotDescription, text: String, change: (World) -> World = { it }): Session {
        val messages = RobolangMessages.of(Language.ENGLISH)
        val result = compileRobolang("test", text, robot.target, messages)
        val program = assertIs<RobolangResult.Success>(result, "$result").program
        val plain = BuiltInWorlds.plainFor(robot.brick)
        val world = change(plain.copy(realism = 0.0, robots = plain.robots.map { it.copy(description = robot) }))
        val session = Session(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), Language.ENGLISH)
        session.runUnattended(60_000)
        session.close()
        return session
    }

    private fun calls(session: Session): List<String> =
        session.callLog.entries.filter { it.sourceLine > 0 }.map { "${it.sourceLine} ${it.callText}" }

    private fun turned(session: Session): Double =
        (session.state.robot.pose.heading - session.world.robots.first().start.heading + 540) % 360 - 180

    private fun driven(session: Session): Double {
        val start = session.world.robots.first().start
        return session.state.robot.pose.let { hypot(it.x - start.x, it.y - start.y) }
    }

    private fun mistakesOf(text: String, robot: RobotDescription): String = assertIs<RobolangResult.Failure>(
        compileRobolang("test", text, robot.target, RobolangMessages.of(Language.ENGLISH)),
    ).diagnostics.joinToString { it.message }

    @Test
    fun `a Cutebot draws a square with the bytes of its maker`() = runTest {
        val session = run(ReadyRobots.CUTEBOT, "pen down\nrepeat 4 times\n  forward 10\n  turn left 90\nend\npen up\n")
        val stop = listOf("i2c 0x10 01 02 00 00", "i2c 0x10 02 02 00 00")
        val ahead = (listOf("i2c 0x10 01 02 2d 00", "i2c 0x10 02 02 2d 00") + stop).map { "3 $it" }
        val left = (listOf("i2c 0x10 01 01 2d 00", "i2c 0x10 02 02 2d 00") + stop).map { "4 $it" }
        val round = ahead + left
        val wanted = listOf("1 i2c 0x10 05 2d 00 00") + round + round + round + round + "6 i2c 0x10 05 5a 00 00"
        assertEquals(wanted, calls(session))
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run)
        assertEquals(40.0, session.state.ink.lengthCentimetres, 2.0)
        assertTrue(driven(session) < 0.5, "${driven(session)}")
        assertTrue(abs(turned(session)) < 1.0, "${turned(session)}")
    }

    @Test
    fun `every ready buggy drives as far and turns as much as its program says`() = runTest {
        for (robot in ReadyRobots.all.values.filter { it.brick.isOnBuggy }) {
            val ahead = run(robot, "forward 20\nwait 1 seconds\n")
            assertEquals(20.0, driven(ahead), 0.6, robot.title)
            // Pulses of servos have coarse steps, which are not the same forward and backward.
            val straight = if (robot.buggy?.kind == BuggyKind.PLAIN) 2.5 else 0.5
            assertTrue(abs(turned(ahead)) < straight, "${robot.title} ${turned(ahead)}")
            assertEquals(-90.0, turned(run(robot, "turn right 90\nwait 1 seconds\n")), 3.0, robot.title)
        }
    }

    @Test
    fun `the calibration of a robot changes its program and its speed alike`() = runTest {
        val slow = ReadyRobots.CUTEBOT.let { it.copy(drive = it.drive.copy(gear = 2.0, track = 9.0)) }
        val usual = run(ReadyRobots.CUTEBOT, "forward 20\nwait 1 seconds\n")
        val session = run(slow, "forward 20\nwait 1 seconds\n")
        assertEquals(20.0, driven(session), 0.6)
        assertEquals(2 * durationOfDrive(usual), durationOfDrive(session))
        val drifting = ReadyRobots.MAQUEEN.let { it.copy(buggy = it.buggy?.copy(trim = WheelTrim(0.9, 1.0))) }
        val straight = run(drifting, "forward 40\nwait 1 seconds\n")
        assertTrue("1 i2c 0x10 00 00 69" in calls(straight), "${calls(straight)}")
        assertTrue(abs(turned(straight)) < 1.0, "${turned(straight)}")
        val bare = ReadyRobots.MAQUEEN
        val target = bare.target
        assertEquals(target.millisecondsPerCentimetre, drifting.target.millisecondsPerCentimetre)
    }

    private fun durationOfDrive(session: Session): Long {
        val wheels = session.callLog.entries.filter { it.sourceLine == 1 && "i2c" in it.callText }
        return wheels.last().milliseconds - wheels.first().milliseconds
    }

    @Test
    fun `a behaviour cuts a drive short, and a new power counts at once`() = runTest {
        val text = "whenever timer > 0.5\n  show 1\n  halt\nend\nforward 100\n"
        val session = run(ReadyRobots.CUTEBOT, text)
        assertEquals(listOf("2 print 1", "2 display show 1"), calls(session).filter { it.startsWith("2 ") })
        assertTrue(driven(session) in 8.0..13.0, "${driven(session)}")
        val faster =
            run(ReadyRobots.CUTEBOT, "start forward\nwait 0.2 seconds\npower right 6\nwait 0.2 seconds\nstop\n")
        assertEquals(
            listOf("i2c 0x10 01 02 2d 00", "i2c 0x10 02 02 55 00"),
            calls(faster).filter { it.startsWith("3 ") }.map { it.drop(2) },
        )
    }

    @Test
    fun `the distance sensor hears the wall, and a drive stops before it`() = runTest {
        val text = "show distance\nshow sensor 3\nstart forward\nwait until distance < 20\nstop\nshow distance\n"
        val printed = calls(run(ReadyRobots.CUTEBOT, text)).filter {
            "print" in it
        }.map { it.substringAfter("print ").toInt() }
        // From the sensor, 5.8 cm ahead of the wheels at 40, to the wall at 100.
        assertEquals(listOf(54, 54), printed.take(2))
        assertTrue(printed[2] in 17..19, "$printed")
    }

    @Test
    fun `a Cutebot follows the edge of a line, which its sensors see as dark`() = runTest {
        val follow =
            "power 2\nrepeat while timer < 6\n  if light < 50\n    motor A forward\n    motor C stop\n  else\n" +
                "    motor A stop\n    motor C forward\n  end\n  wait 20 milliseconds\nend\n"
        val line = Mark(MarkFigure.Line(listOf(Point(30.0, 40.0), Point(95.0, 40.0)), width = 2.0))

        fun atLine(world: World) =
            world.copy(marks = listOf(line), robots = world.robots.map { it.copy(start = Pose(40.0, 39.0, 0.0)) })
        val shown = run(ReadyRobots.CUTEBOT, "show light\nshow sensor 2\n", ::atLine)
        assertEquals(listOf("0", "100"), calls(shown).filter { "print" in it }.map { it.substringAfter("print ") })
        val session = run(ReadyRobots.CUTEBOT, follow, ::atLine)
        val end = session.state.robot.pose
        assertTrue(end.x > 60 && abs(end.y - 39) < 2, "$end")
        val without = run(ReadyRobots.CUTEBOT, "show light\n").let(::calls).first()
        assertEquals("1 print 100", without)
    }

    @Test
    fun `what a board cannot do is said while one types`() {
        val robot = ReadyRobots.CUTEBOT_V1
        assertTrue("battery" in mistakesOf("show battery\n", robot))
        assertTrue("degrees of its motors" in mistakesOf("motor A turn 90\n", robot))
        assertTrue("colour sensor" in mistakesOf("show colour\n", robot))
        assertTrue("microphone" in mistakesOf("show loudness\n", robot))
        assertTrue("no such button" in mistakesOf("if button escape\n  beep\nend\n", robot))
        for (button in listOf("enter", "run", "left", "prgm", "right", "view")) {
            val text = "if button $button\n  beep\nend\n"
            val result = compileRobolang("test", text, robot.target, RobolangMessages.of(Language.ENGLISH))
            assertIs<RobolangResult.Success>(result, "$button $result")
        }
    }
}
