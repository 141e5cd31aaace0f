package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.brick.kind.ProgramUpload
import robotran.brick.sensors.SensorKind
import robotran.brick.state.RunState
import robotran.language.Language
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.RobolangMessages
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.Facing
import robotran.world.Lamp
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.SensorPart
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Point
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Robolang on robots with a hub, in the simulated world. */
class HubRunTest {
    private suspend fun run(robot: RobotDescription, text: String, lamp: Lamp? = null): Session {
        val messages = RobolangMessages.of(Language.ENGLISH)
        val result = compileRobolang("test", text, robot.target, messages)
        val program = assertIs<RobolangResult.Success>(result, "$result").program
        val plain = BuiltInWorlds.plainFor(robot.brick)
        val world = plain.copy(
            realism = 0.0,
            robots = plain.robots.map { it.copy(description = robot) },
            lamps = listOfNotNull(lamp),
        )
        val session = Session(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), Language.ENGLISH)
        session.runUnattended(60_000)
        session.close()
        return session
    }

    private fun calls(session: Session): List<String> =
        session.callLog.entries.filter { it.sourceLine > 0 }.map { "${it.sourceLine} ${it.callText}" }

    /** The number that a program has shown. */
    private fun shown(session: Session): Int =
        calls(session).last { "display number" in it }.substringAfterLast(' ').toInt()

    /** What the sheet and the charts show of the sensor on port D. */
    private fun plate(session: Session): Int? = session.state.brick.inputs[3].measured(SensorKind.COLOUR)

    @Test
    fun `a SPIKE penbot draws a square with the calls of its Python`() = runTest {
        val session =
            run(ReadyRobots.SPIKE_PENBOT, "pen down\nrepeat 4 times\n  forward 10\n  turn left 90\nend\npen up\n")
        val begin = listOf(
            "3 device Motor A counterclockwise",
            "3 device Motor B",
            "1 device Motor C",
            "3 drive_base create 56 112",
            "1 motor C reset_angle 0",
            "1 motor C run_target 300 90",
        )
        val round = listOf("3 drive_base straight 100", "4 drive_base turn -90")
        assertEquals(begin + round + round + round + round + "6 motor C run_target 300 0", calls(session))
        val start = session.world.robots.first().start
        val end = session.state.robot.pose
        assertEquals(RunState.Ended(stopped = false), session.state.brick.run)
        assertEquals(40.0, session.state.ink.lengthCentimetres, 1.0)
        assertTrue(abs(end.x - start.x) < 1.0 && abs(end.y - start.y) < 1.0, "$end")
    }

    @Test
    fun `every hub drives as far and turns as much as its program says`() = runTest {
        for (kind in BrickKind.entries.filter { it.programUpload == ProgramUpload.HUB }) {
            val robot = ReadyRobots.defaultOf(kind)
            val session = run(robot, "forward 20\nturn right 90\nstart forward\nwait 0.5 seconds\nstop\n")
            val start = session.world.robots.first().start
            val turned = (session.state.robot.pose.heading - start.heading + 360) % 360
            assertEquals(270.0, turned, 2.0, "${kind.label} ${calls(session)}")
        }
    }

    @Test
    fun `a new power counts at once while the robot drives, for both wheels and for one`() = runTest {
        val both = run(ReadyRobots.SPIKE_PENBOT, "start forward\nwait 0.5 seconds\npower 6\nwait 0.5 seconds\nstop\n")
        val wanted = listOf(
            "1 drive_base drive 176 0",
            "3 drive_base settings 352 360",
            "3 drive_base drive 352 0",
            "5 drive_base brake",
        )
        assertEquals(wanted, calls(both).filter { "drive_base" in it && "create" !in it }.distinct())
        val left = run(ReadyRobots.SPIKE_PENBOT, "start forward\nwait 0.5 seconds\npower left 6\nwait 0.5 seconds\n")
        assertEquals("3 motor A run 720", calls(left).last { " run " in it })
        assertTrue(left.state.robot.pose.heading != left.world.robots.first().start.heading)
    }

    @Test
    fun `numbers are printed and lit, and beyond 31 bits the program ends at its line`() = runTest {
        val session = run(ReadyRobots.SPIKE_PENBOT, "show 7\nvar a = 32768\nshow a * a\n")
        assertEquals(listOf("1 print \"7\"", "1 display number 7"), calls(session))
        val failed = assertIs<RunState.Failed>(session.state.brick.run)
        assertEquals(3, failed.failure.sourceLine)
        assertEquals(
            "A number has become larger than 1,073,741,823, more than this hub can hold.",
            failed.failure.message,
        )
    }

    @Test
    fun `a light sensor that looks ahead tells the light from there, as its Python does`() = runTest {
        val header = { facing: String -> "robot\n  brick spike\n  light sensor on 4 facing $facing\nend\n" }
        val robot = ReadyRobots.SPIKE_PENBOT
        val ahead = robot.copy(
            parts = robot.parts.map { if (it is SensorPart) it.copy(facing = Facing.Ahead(0.0)) else it },
        )
        val dark = shown(run(ahead, header("forward") + "show light\n"))
        val start = BuiltInWorlds.plainFor(robot.brick).robots.first().start
        val radians = start.heading * PI / 180
        val lamp = Lamp(Point(start.x + 30 * cos(radians), start.y + 30 * sin(radians)))
        val lit = run(ahead, header("forward") + "show light\n", lamp)
        assertTrue(shown(lit) > dark + 10)
        assertEquals(shown(lit), plate(lit))
        // Without a header Python asks for the light of the sensor's own lamp, wherever it looks.
        val own = run(ahead, "show light\n", lamp)
        assertEquals(shown(own), plate(own))
        assertTrue(plate(own) != plate(lit))
        // Downwards it tells how bright the paper is in its own light.
        assertEquals(shown(run(robot, header("down") + "show light\n")), shown(run(robot, "show light\n")))
    }
}
