package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
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
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.World
import robotran.world.file.BuiltInWorlds
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
    fun `line sensors know light and dark, and the sonar how far a wall is`() = runTest {
        val dark = BuiltInWorlds.plainFor(BrickKind.MICROBIT)
        val session = run(ReadyRobots.CUTEBOT, "show light\nshow sensor 2\nshow distance\nshow sensor 3\n")
        assertTrue(dark.robots.isNotEmpty())
        val printed = calls(session).filter { "print" in it }.map { it.substringAfter("print ") }
        assertEquals(listOf("100", "100"), printed.take(2))
        assertEquals(printed[2], printed[3])
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
