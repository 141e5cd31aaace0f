package robotran.workshop.robot

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.WheelTrim
import robotran.editing.Field
import robotran.language.Language
import robotran.projects.target
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.messages.PythonTranslationMessages
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.python.translateToPython
import robotran.robolang.robot.RobotTarget
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.after
import robotran.robotediting.fieldsOf
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.round
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/**
 * A buggy on the floor is not the one that the app thinks it is. The drives of docs/microbit.md, read off with a ruler and typed
 * into the workbench, make it one.
 */
class MeasuredBuggyTest {
    @Test
    fun `three drives read off with a ruler put the program of a differing buggy right`() {
        for ((name, real) in differing) {
            val believed = ReadyRobots.all.getValue(name)
            val ahead = drive(real, believed, "forward 50")
            val turned = drive(real, believed, "turn right 360").turned
            assertTrue(abs(ahead.way - 50) > 4 && abs(turned - 360) > 15, "$name differs: $ahead, $turned")
            // What is still off is typed in once more: power and speed are not quite in proportion.
            val measured = measuredOnce(real, measuredOnce(real, believed))
            val again = drive(real, measured, "forward 50")
            assertEquals(50.0, again.way, 1.0, name)
            assertEquals(0.0, again.side, FINEST_SIDE, name)
            assertEquals(360.0, drive(real, measured, "turn right 360").turned, 6.0, name)
            assertEquals(50.0, drive(measured, measured, "forward 50").way, 1.0, "$name on the sheet")
        }
    }

    /** [believed] with what [real] does with its program, in steps of a ruler and of a circle. */
    private fun measuredOnce(real: RobotDescription, believed: RobotDescription): RobotDescription {
        val ahead = drive(real, believed, "forward 50")
        return RobotEditing.of(believed).after(RobotEdit.Choose(RobotElement.Wheels))
            .typed("robot-measured-way", round(ahead.way * 2) / 2)
            .typed("robot-measured-side", round(ahead.side * 2) / 2)
            .typed("robot-measured-turn", round(drive(real, believed, "turn right 360").turned)).robot
    }

    @Test
    fun `the Python of a measured buggy has its numbers`() {
        val believed = ReadyRobots.CUTEBOT
        val measured = RobotEditing.of(believed).after(RobotEdit.Choose(RobotElement.Wheels))
            .typed("robot-measured-way", 40.0).typed("robot-measured-turn", 300.0).robot
        val (before, after) = listOf(believed, measured).map { pythonOf(it) }
        assertEquals(50.0 / 40.0, after.number("CM") / before.number("CM"), 0.02)
        assertEquals(360.0 / 300.0, after.number("DEG") / before.number("DEG"), 0.02)
    }

    private fun String.number(name: String): Double =
        checkNotNull(Regex("(?m)^$name = ([0-9.]+)").find(this)) { this }.groupValues[1].toDouble()

    private fun pythonOf(robot: RobotDescription): String {
        val program = compiled("forward 10\nturn left 90\n", robot)
        return translateToPython(
            program,
            assertIs<RobotTarget.Microbit>(robot.target),
            PythonTranslationMessages.of(Language.ENGLISH),
        ).python
    }

    /** How far a robot came ahead, how far it is to the left of its way then, and how far it has turned to the right. */
    private data class Drive(val way: Double, val side: Double, val turned: Double)

    /** The robot [real] does [text], compiled for [believed]. */
    private fun drive(real: RobotDescription, believed: RobotDescription, text: String): Drive = runBlocking {
        val plain = BuiltInWorlds.plainFor(real.brick)
        val start = Pose(60.0, 100.0, 0.0)
        val robots = plain.robots.map { it.copy(start = start, description = real) }
        val world = plain.copy(realism = 0.0, paper = Paper(200.0, 200.0), robots = robots)
        val programs = listOf(RobotProgramSet(listOf(compiled("$text\nwait 1 second\n", believed))))
        val session = Session(world, programs, loadPhysicsEngine(), Language.ENGLISH)
        session.runUnattended(LIMIT)
        val end = session.state.robot.pose
        session.close()
        val towards = start.heading * PI / 180
        val (x, y) = end.x - start.x to end.y - start.y
        val beyond = (start.heading - end.heading - 360 + 540 + 720) % 360 - 180
        Drive(x * cos(towards) + y * sin(towards), y * cos(towards) - x * sin(towards), 360 + beyond)
    }

    private fun compiled(text: String, robot: RobotDescription): RobolangProgram = assertIs<RobolangResult.Success>(
        compileRobolang("drive", text, robot.target, RobolangMessages.of(Language.ENGLISH)),
    ).program

    private fun RobotEditing.typed(tag: String, value: Double): RobotEditing {
        val field = fieldsOf(RobotElement.Wheels).filterIsInstance<Field.Number<RobotEdit>>().single { it.tag == tag }
        return after(checkNotNull(field.with(value)) { "$tag $value" })
    }

    private companion object {
        const val LIMIT = 60_000

        /** Half of what one percent of 45 moves a buggy beside its way of 50 cm: a wheel's power has whole percents. */
        const val FINEST_SIDE = 1.9

        /** By the ready robot that the app takes each for. */
        val differing = mapOf(
            "cutebot" to ReadyRobots.CUTEBOT.differing(gear = 0.75, track = 8.4, WheelTrim(0.96, 1.0)),
            "maqueen" to ReadyRobots.MAQUEEN.differing(gear = 1.3, track = 7.0, WheelTrim(1.0, 0.97)),
            "kitronik-penbot" to ReadyRobots.KITRONIK_PENBOT.differing(gear = 1.2, track = 9.0, WheelTrim(1.0, 1.0)),
        )

        private fun RobotDescription.differing(gear: Double, track: Double, trim: WheelTrim) =
            copy(drive = drive.copy(gear = gear, track = track), buggy = buggy?.copy(trim = trim))
    }
}
