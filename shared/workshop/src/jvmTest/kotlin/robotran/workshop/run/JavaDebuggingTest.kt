package robotran.workshop.run

import kotlinx.coroutines.runBlocking
import robotran.brick.program.StepKind
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.simulation.Breakpoint
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.WorkshopStatus
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Breakpoints, steps and failures of Java programs. */
class JavaDebuggingTest {
    private val counting = SourceFile(
        "Counting.java",
        "import josx.platform.rcx.LCD;\n\npublic class Counting {\n    public static void main(String[] args) {\n" +
            "        int rounds = 0;\n        while (rounds < 5) {\n            rounds = Helper.next(rounds);\n      " +
            "  }\n    }\n}\n",
    )
    private val helper = SourceFile(
        "Helper.java",
        "class Helper {\n\n    static int next(int number) {\n        number = number + 1;\n        return number;\n " +
            "   }\n}\n",
    )
    private val alone = Program.of(
        "Alone.java",
        "public class Alone {\n    public static void main(String[] args) {\n" +
            "        int x = 1;\n        x = x + 1;\n        x = 10 / (x - 2);\n    }\n}\n",
    )
    private val several = Program.of(listOf(counting, helper))

    @Test
    fun `a program of one file stops at its breakpoint`() = workshop(alone) { workshop ->
        workshop.handle(ProgramEvent.BreakpointToggled(4))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
        assertEquals(WorkshopStatus.Paused(4), workshop.state.status)
        assertEquals(4, workshop.state.shownProgramRun.runningLine)
    }

    @Test
    fun `a program of several files stops in the one with the breakpoint, which is turned to`() =
        workshop(several) { workshop ->
            workshop.handle(ProgramEvent.FileChosen(1))
            workshop.handle(ProgramEvent.BreakpointToggled(4))
            workshop.handle(ProgramEvent.FileChosen(0))
            workshop.handle(RunEvent.RunPressed)
            repeat(3) {
                workshop.advance(1_000)
                assertEquals(WorkshopStatus.Paused(4), workshop.state.status)
                assertEquals(
                    listOf("Helper.java", 4),
                    listOf(workshop.state.file.name, workshop.state.shownProgramRun.runningLine),
                )
                workshop.handle(ProgramEvent.FileChosen(0))
                workshop.advance(100)
                assertEquals("Counting.java", workshop.state.file.name, "whoever looks elsewhere is left alone")
                workshop.handle(RunEvent.PausePressed)
            }
            // The first line of this file also stops, but line 4 of the other file does not.
            workshop.handle(RunEvent.StopPressed)
            workshop.handle(RunEvent.RunToLine(Breakpoint(5, "Counting.java")))
            workshop.advance(1_000)
            assertEquals(
                listOf("Counting.java", 5),
                listOf(workshop.state.file.name, workshop.state.shownProgramRun.runningLine),
            )
        }

    @Test
    fun `the first step shows the line that is about to run, and the next one runs it`() =
        workshop(several) { workshop ->
            val lines = List(2) {
                workshop.handle(RunEvent.StepPressed(StepKind.OVER))
                workshop.advance(1_000)
                workshop.state.shownProgramRun.runningLine
            }
            assertEquals(listOf(5, 6), lines)
            assertTrue(workshop.state.run.isPaused)
        }

    @Test
    fun `an exception that nobody catches is told at its line until the program is changed`() =
        workshop(alone) { workshop ->
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1_000)
            assertEquals(5, assertNotNull(workshop.state.shownProgramRun.failure).sourceLine)
            workshop.handle(ProgramEvent.ProgramEdited(workshop.state.programText + "\n"))
            assertNull(workshop.state.shownProgramRun.failure)
        }

    @Test
    fun `a failure in another file turns to that file`() {
        val failing = helper.copy(text = helper.text.replace("number + 1", "number / 0"))
        workshop(Program.of(listOf(counting, failing))) { workshop ->
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1_000)
            assertEquals("Helper.java", workshop.state.file.name)
            assertEquals(4, assertNotNull(workshop.state.shownProgramRun.failure).sourceLine)
            workshop.handle(ProgramEvent.FileChosen(0))
            workshop.advance(100)
            assertEquals("Counting.java", workshop.state.file.name)
            assertNull(workshop.state.shownProgramRun.failure)
        }
    }

    @Test
    fun `a failure of Robolang is told at its line, too`() =
        workshop(Program.of("a.robo", "var x = 0\nbeep\nshow 10 / x")) { workshop ->
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1_000)
            assertEquals(3, assertNotNull(workshop.state.shownProgramRun.failure).sourceLine)
            workshop.handle(RunEvent.StartedOver)
            assertNull(workshop.state.shownProgramRun.failure)
        }

    private fun workshop(program: Program, check: suspend (Workshop) -> Unit) = runBlocking {
        val workshop = openWorkshop(listOf(program))
        workshop.compilePrograms()
        check(workshop)
        workshop.close()
    }
}
