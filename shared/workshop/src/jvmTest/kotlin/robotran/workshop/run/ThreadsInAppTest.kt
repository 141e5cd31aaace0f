package robotran.workshop.run

import kotlinx.coroutines.runBlocking
import robotran.brick.kind.BrickKind
import robotran.brick.program.StepKind
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.openWorkshop
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.WorkshopStatus
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A pupil looks at the threads of a Java program in three files, on both bricks. */
class ThreadsInAppTest {
    private fun walking(import: String) = Program.of(
        listOf(
            SourceFile(
                "Main.java",
                "import $import;\n\npublic class Main {\n" +
                    "    public static void main(String[] args) throws InterruptedException {\n" +
                    "        new Walker().start();\n        int rounds = 0;\n        while (rounds < 50) {\n" +
                    "            Thread.sleep(100);\n            rounds = rounds + 1;\n        }\n    }\n}\n",
            ),
            SourceFile(
                "Walker.java",
                "class Walker extends Thread {\n    public void run() {\n        int steps = 0;\n" +
                    "        while (steps < 100) {\n            steps = Pace.next(steps);\n" +
                    "            try { Thread.sleep(30); } catch (InterruptedException e) { }\n        }\n    }\n}\n",
            ),
            SourceFile(
                "Pace.java",
                "class Pace {\n    static int next(int number) {\n        return number + 1;\n    }\n}\n",
            ),
        ),
    )

    @Test
    fun `a chosen thread shows its source, and Step steps it, into, over and out`() = onBothBricks { workshop ->
        stopInPace(workshop)
        workshop.handle(ProgramEvent.BreakpointToggled(3))
        workshop.choose("main")
        assertEquals("Main.java 8", workshop.place)
        assertEquals(WorkshopStatus.Paused(8), workshop.state.status)
        val places = listOf(StepKind.INTO, StepKind.OVER, StepKind.INTO, StepKind.OVER).map { kind ->
            workshop.handle(RunEvent.StepPressed(kind))
            workshop.advance(1_000)
            assertEquals("main", workshop.chosen)
            workshop.place
        }
        assertEquals(listOf("Main.java 9", "Main.java 7", "Main.java 8", "Main.java 9"), places)
        workshop.choose("Walker")
        assertEquals("Walker.java", workshop.state.file.name)
    }

    @Test
    fun `a frame that is chosen shows its source, each time`() = onBothBricks { workshop ->
        stopInPace(workshop)
        assertEquals("Pace.java 3", workshop.place)
        val thread = workshop.variables.thread
        workshop.handle(RunEvent.FrameChosen(thread, 1))
        assertEquals("Walker.java 5", workshop.place)
        workshop.handle(ProgramEvent.FileChosen(0))
        workshop.advance(100)
        assertEquals("Main.java", workshop.state.file.name)
        workshop.handle(RunEvent.FrameChosen(thread, 1))
        assertEquals("Walker.java 5", workshop.place)
        workshop.handle(RunEvent.StepPressed(StepKind.OUT))
        workshop.advance(1_000)
        assertEquals("Walker.java 6", workshop.place)
    }

    @Test
    fun `a breakpoint of another thread is shown, whichever thread was to step`() = onBothBricks { workshop ->
        stopInPace(workshop)
        workshop.choose("main")
        workshop.handle(RunEvent.StepPressed(StepKind.OVER))
        workshop.advance(60)
        assertTrue(workshop.state.run.isPaused)
        assertEquals("Walker" to "Pace.java 3", workshop.chosen to workshop.place)
        workshop.choose("main")
        assertEquals("Main.java 8", workshop.place)
        workshop.handle(RunEvent.PausePressed)
        workshop.advance(60)
        assertEquals("Walker" to "Pace.java 3", workshop.chosen to workshop.place)
    }

    /** Runs to a breakpoint in the last file, with the threads in sight. */
    private suspend fun stopInPace(workshop: Workshop) {
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        workshop.handle(ProgramEvent.FileChosen(2))
        workshop.handle(ProgramEvent.BreakpointToggled(3))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
    }

    private val Workshop.variables get() = state.run.drawer.variables

    private val Workshop.chosen get() = variables.threads.single { it.number == variables.thread }.name

    private val Workshop.place get() = "${state.file.name} ${state.shownProgramRun.runningLine}"

    private fun Workshop.choose(thread: String) =
        handle(RunEvent.FrameChosen(variables.threads.single { it.name == thread }.number, 0))

    private fun onBothBricks(check: suspend (Workshop) -> Unit) = runBlocking {
        for ((brick, import) in listOf(BrickKind.RCX to "josx.platform.rcx.*", BrickKind.NXT to "lejos.nxt.*")) {
            val workshop = openWorkshop(listOf(walking(import)))
            workshop.handle(WorldEditEvent.PenbotChosen(workshop.state.programs.shownRobot, brick))
            workshop.compilePrograms()
            assertEquals(emptyList(), workshop.state.diagnostics)
            check(workshop)
            workshop.close()
        }
    }
}
