package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.world.file.BuiltInWorlds
import robotran.world.geometry.Pose
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class NxtLoadsTest {
    private val reader = ProgramCompiler(PENBOT_TARGET, language = Language.ENGLISH)
    private val world = BuiltInWorlds.plain.copy(
        robots = listOf(
            RobotPlacement(Pose(20.0, 20.0, 0.0), "ann"),
            RobotPlacement(
                Pose(60.0, 20.0, 0.0),
                "bob",
                description = ReadyRobots.NXT_PENBOT,
                program = "forward 5 cm",
            ),
            RobotPlacement(Pose(60.0, 60.0, 0.0), "carl", description = ReadyRobots.SUMO),
        ),
    )
    private val forNxt = Program(
        "Go.java",
        ProgramLanguage.JAVA,
        listOf(
            SourceFile(
                "Go.java",
                "import lejos.nxt.*;\nclass Go {\n  public static void main(String[] a) { Motor.A.forward(); }\n}",
            ),
        ),
    )

    @Test
    fun `each robot gets programs for its own brick`() = runTest {
        val beep = Program("beep.robo", ProgramLanguage.ROBOLANG, "beep")
        val given = mapOf("ann" to listOf(beep), "carl" to listOf(forNxt, beep))
        val loads = assertIs<RobotProgramSets.Success>(readRobotLoads(world, reader, given)).loads
        assertEquals(
            listOf(listOf(BrickKind.RCX), listOf(BrickKind.NXT), listOf(BrickKind.NXT, BrickKind.NXT)),
            loads.map { load -> load.programs.map { it?.kind } },
        )
    }

    @Test
    fun `a program for the other brick is told with its robot`() = runTest {
        val mistaken = assertIs<RobotProgramSets.Failure>(readRobotLoads(world, reader, mapOf("ann" to listOf(forNxt))))
        assertEquals("ann", mistaken.robot)
        assertEquals(1, mistaken.diagnostics.single().range?.line)
    }
}
