package robotran.programs

import kotlinx.coroutines.test.runTest
import robotran.brick.controls.BrickButton
import robotran.brick.controls.MotorMode
import robotran.brick.program.BrickProgram
import robotran.brick.sensors.SensorKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.robolang.robot.RobotTarget
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.SessionInput
import robotran.simulation.physics.loadPhysicsEngine
import robotran.world.Facing
import robotran.world.Paper
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.SensorPart
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** An NXT steers an RCX with LEGO's firmware. */
class RcxLinkTest {
    private suspend fun compiled(source: ProgramSource, target: RobotTarget): BrickProgram =
        assertIs<ProgramResult.Success>(
            ProgramCompiler(target, language = Language.ENGLISH).compileOrThrow(source),
            "$source",
        ).program

    private val world = World(
        "Two bricks",
        Paper(400.0, 300.0),
        listOf(
            RobotPlacement(
                Pose(200.0, 150.0, 0.0),
                description = ReadyRobots.NXT_PENBOT.copy(
                    parts = listOf(SensorPart(1, SensorKind.RCX_LINK, Point(7.0, 0.0), 6.0, Facing.Ahead(0.0))),
                ),
            ),
            RobotPlacement(Pose(200.0, 100.0, 0.0), name = "red"),
        ),
    )

    private suspend fun session(statements: String): Session {
        val java = """
            import lejos.nxt.SensorPort;
            import lejos.nxt.addon.RCXLink;
            import lejos.util.Delay;

            public class Steer {
                public static void main(String[] arguments) {
                    RCXLink link = new RCXLink(SensorPort.S1);
                    Delay.msDelay(300);
                    $statements
                    Delay.msDelay(100000);
                }
            }
        """.trimIndent()
        val steer =
            compiled(Program("Steer.java", ProgramLanguage.JAVA, java), nxtTestTarget)
        val nqc = "task main() { while (true) { if (Message() == 7) OnFwd(OUT_A); Wait(5); } }"
        val waits =
            compiled(Program("waits.nqc", ProgramLanguage.NQC, nqc), testTarget)
        val session =
            Session(
                world,
                listOf(steer, waits).map {
                    RobotProgramSet(listOf(it))
                },
                loadPhysicsEngine(),
                Language.ENGLISH,
            )
        session.apply(SessionInput.Press(BrickButton.ENTER, 0))
        session.apply(SessionInput.Press(BrickButton.RUN, 1))
        session.advance(200)
        session.apply(SessionInput.Release(BrickButton.ENTER, 0))
        session.apply(SessionInput.Release(BrickButton.RUN, 1))
        return session
    }

    @Test
    fun `the link drives the motors of an RCX and stops them`() = runTest(timeout = 3.minutes) {
        val session = session(
            "link.A.forward(); link.C.forward(); link.A.setPower(100); link.C.setPower(100);" +
                "Delay.msDelay(1000); link.A.stop(); link.C.stop();",
        )
        session.advance(1_800)
        val rcx = session.state.robots[1]
        assertEquals(MotorMode.FORWARD, rcx.brick.motors[0].mode, "${rcx.brick.motors}")
        assertEquals(MotorMode.FORWARD, rcx.brick.motors[2].mode, "${rcx.brick.motors}")
        session.advance(2_000)
        val stopped = session.state.robots[1]
        assertEquals(MotorMode.BRAKE, stopped.brick.motors[0].mode, "${stopped.brick.motors}")
        assertTrue(stopped.robot.pose.x > 210, "${stopped.robot.pose}")
        assertEquals(emptyList(), session.warnings.map { it.message })
    }

    @Test
    fun `the program of an RCX hears a number from the link`() = runTest(timeout = 3.minutes) {
        assertEquals(false, session("link.sendF7(6);").isHeard())
        assertEquals(true, session("link.sendF7(7);").isHeard())
    }

    /** Whether the RCX has switched its motor A on after one and a half seconds. */
    private fun Session.isHeard(): Boolean {
        advance(1_500)
        return state.robots[1].brick.motors[0].mode == MotorMode.FORWARD
    }
}
