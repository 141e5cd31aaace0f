package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.program.BrickProgram
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.JavaSettings
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.simulation.state.RobotState
import robotran.tinyvm.config.TinyVmSpeed
import robotran.world.PenMount
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.file.BuiltInWorlds
import robotran.world.robot.robotErrors
import kotlin.math.PI
import kotlin.math.abs
import kotlin.math.cos
import kotlin.math.sin
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Robolang and its translation drive robots whose motors are elsewhere, the other way round or behind gears. */
class OtherDrivesTest {
    private fun RobotDescription.built(
        left: MotorPort,
        right: MotorPort,
        pen: MotorPort?,
        reversed: Boolean,
        gear: Double = drive.gear,
    ) = copy(
        drive = drive.copy(left = left, right = right, reversed = reversed, gear = gear),
        pen = pen?.let { PenMount(it) },
        parts = emptyList(),
    ).also { assertEquals(emptyList(), robotErrors(it)) }

    private fun robots(penbot: RobotDescription): List<RobotDescription> = listOf(
        penbot.built(MotorPort.C, MotorPort.A, MotorPort.B, reversed = false),
        penbot.built(MotorPort.B, MotorPort.A, MotorPort.C, reversed = true),
        penbot.built(MotorPort.A, MotorPort.C, pen = null, reversed = true),
        penbot.built(MotorPort.B, MotorPort.C, pen = null, reversed = false, gear = penbot.drive.gear * 1.5),
    )

    private suspend fun run(robot: RobotDescription, program: BrickProgram, text: String): RobotState {
        val plain = BuiltInWorlds.plainFor(robot.brick)
        val world = plain.copy(robots = plain.robots.map { it.copy(description = robot) })
        val session = Session(world, listOf(RobotProgramSet(listOf(program))), loadPhysicsEngine(), Language.ENGLISH)
        session.runUnattended(60_000)
        session.close()
        val state = session.state.robot
        val what = "$text of $robot: $state"
        val start = plain.start
        val turned = (state.pose.heading - start.heading + 360) % 360
        assertEquals(90.0, turned, 1.5, what)
        val angle = PI / 180 * start.heading
        val ahead = (state.pose.x - start.x) * cos(angle) + (state.pose.y - start.y) * sin(angle)
        // 10 cm and a second.
        assertTrue(ahead > 25, what)
        val ink = session.state.ink.lengthCentimetres
        assertTrue(if (robot.pen == null) ink == 0.0 else abs(ink - ahead) < 3.0, "$what drew $ink cm")
        return state
    }

    private suspend fun check(brick: BrickKind) {
        val text = "pen down\nforward 10 cm\npower 4\nforward for 0.5 seconds\nstart forward\nwait 0.5 seconds\n" +
            "stop\npen up\npower 3\nturn left 90"
        for (robot in robots(ReadyRobots.defaultOf(brick))) {
            val compiler =
                ProgramCompiler(robot.target, JavaSettings(speed = TinyVmSpeed.UNLIMITED), language = Language.ENGLISH)
            val source = Program("drive.robo", ProgramLanguage.ROBOLANG, text)
            val program = assertIs<ProgramResult.Success>(compiler.compileOrThrow(source)).program
            val one = run(robot, program, "run")
            val translation = assertIs<ProgramResult.Success>(compiler.compileTranslation(source)).program
            val other = run(robot, translation, "translation")
            assertEquals(one.pose.x, other.pose.x, 0.2, "$robot")
            assertEquals(one.pose.y, other.pose.y, 0.2, "$robot")
            assertEquals(one.pose.heading, other.pose.heading, 1.0, "$robot")
        }
    }

    @Test
    fun `robots with an RCX drive ahead and turn left`() = runTest { check(BrickKind.RCX) }

    @Test
    fun `robots with an NXT drive ahead and turn left`() = runTest { check(BrickKind.NXT) }
}
