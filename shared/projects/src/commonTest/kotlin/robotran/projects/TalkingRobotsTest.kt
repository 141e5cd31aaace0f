package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.rcxrom.state.RcxState
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.runUnattended
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** Robots whose programs are in different languages, on different firmwares, talk by infrared light. */
class TalkingRobotsTest {
    private val world = BuiltInWorlds.plain.copy(
        robots = listOf("nqc", "java", "robolang", "other nqc").mapIndexed { place, name ->
            RobotPlacement(Pose(20.0, 16.0 + place * 16.0, 0.0), name)
        },
    )

    /** Asks the robot in Java, and then wakes the one in Robolang as LEGO's remote control does. */
    private val asking = nqc(
        """
        task main()
        {
            ClearMessage();
            Wait(300);
            SendMessage(5);
            until (Message() == 6);
            Wait(200);  // the remote control wakes every brick, so others drive first
            SetSerialPacket(SERIAL_PACKET_RCX + SERIAL_PACKET_CHECKSUM);
            SetSerialData(0, 0xd2);
            SetSerialData(1, 0x02);  // its button P1
            SetSerialData(2, 0x00);
            SendSerial(0, 3);
            Wait(200);
        }
        """,
    )

    private val answering = Program(
        "Answering.java",
        ProgramLanguage.JAVA,
        listOf(
            SourceFile(
                "Answering.java",
                """
                import josx.platform.rcx.*;
                class Answering {
                    public static void main(String[] args) throws InterruptedException {
                        while (!Message.isAvailable()) Thread.sleep(20);
                        int asked = Message.get();
                        Thread.sleep(100);
                        Message.send((byte) (asked + 1));
                        LCD.showNumber(asked);
                        while (true) Thread.sleep(100);
                    }
                }
                """.trimIndent(),
            ),
        ),
    )

    /** Hears both, and drives as many centimetres as the sum says. */
    private val listening = nqc(
        """
        int sum = 0;

        task main()
        {
            SetPower(OUT_A + OUT_C, OUT_HALF);
            repeat (2)
            {
                ClearMessage();
                until (Message() != 0);
                sum += Message();
            }
            OnFwd(OUT_A + OUT_C);
            Wait(sum * 5);
            Off(OUT_A + OUT_C);
        }
        """,
    )

    private fun nqc(text: String) = Program("a.nqc", ProgramLanguage.NQC, text.trimIndent())

    @Test
    fun `NQC asks Java and wakes Robolang while another robot listens`() = runTest {
        val programs = mapOf(
            "nqc" to listOf(asking),
            "java" to listOf(answering),
            "robolang" to listOf(Program("drive.robo", ProgramLanguage.ROBOLANG, "forward 10")),
            "other nqc" to listOf(listening),
        )
        val result = readRobotLoads(world, ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH), programs)
        val session =
            Session(world, assertIs<RobotProgramSets.Success>(result).loads, loadPhysicsEngine(), Language.ENGLISH)
        session.runUnattended(MILLISECONDS)
        val robots = session.state.robots
        assertEquals(5, assertIs<RcxState>(robots[1].brick).glass.text.trim().substringBefore(' ').toInt())
        val driven = robots.map { it.robot.pose.x - 20.0 }
        assertEquals(listOf(0.0, 0.0, TWICE, SUM), driven.map { kotlin.math.round(it) }, "$driven")
        session.close()
    }

    private companion object {
        const val MILLISECONDS = 10_000

        /** Centimetres of two runs of the program in Robolang. */
        const val TWICE = 20.0

        /** Of the messages 5 and 6. */
        const val SUM = 11.0
    }
}
