package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.language.ProgramLanguage
import robotran.languagesupport.SourceFile
import robotran.programs.Program
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.examples.examples
import robotran.workshop.state.CompileStatus
import robotran.workshop.state.Notice
import robotran.workshop.state.WorkshopStatus
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

class WorkshopJavaTest {
    private val firstDrive = Program.of("FirstDrive.java", ProgramLanguage.JAVA.examples.getValue("FirstDrive.java"))
    private val sleepingLine = firstDrive.files.single().text.lines().indexOfFirst { "Thread.sleep" in it } + 1

    @Test
    fun `a Java program is compiled and drives`() = workshop(firstDrive) { workshop ->
        workshop.compilePrograms()
        assertEquals(WorkshopStatus.Ready, workshop.state.status)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1000)
        assertEquals(WorkshopStatus.Running(sleepingLine), workshop.state.status)
        assertEquals(sleepingLine, workshop.state.shownProgramRun.runningLine)
        workshop.advance(2000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x > workshop.state.world.start.x + 30)
    }

    @Test
    fun `a program that is run before it was compiled runs as soon as it is`() = workshop(firstDrive) { workshop ->
        workshop.handle(RunEvent.RunPressed)
        assertEquals(WorkshopStatus.Compiling, workshop.state.status)
        workshop.compilePrograms()
        assertTrue(workshop.state.running)
    }

    @Test
    fun `who changes the program or presses Stop meanwhile does not wait for it any more`() {
        for (event in listOf(RunEvent.StopPressed, ProgramEvent.ProgramEdited(firstDrive.files.single().text + "\n"))) {
            workshop(firstDrive) { workshop ->
                workshop.handle(RunEvent.RunPressed)
                workshop.handle(event)
                workshop.compilePrograms()
                assertFalse(workshop.state.running)
            }
        }
    }

    @Test
    fun `the sample of the paper is told why the robot stands still`() = workshop(paperSample) { workshop ->
        workshop.compilePrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertContains(workshop.state.session.brick.explanation.orEmpty(), "has come to its end")
    }

    @Test
    fun `Stop ends an endless loop at once`() = workshop(mainOf("while (true) { }")) { workshop ->
        workshop.compilePrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1000)
        assertTrue(workshop.state.running)
        workshop.handle(RunEvent.StopPressed)
        assertEquals(WorkshopStatus.Ended(stopped = true), workshop.state.status)
    }

    @Test
    fun `a mistake is told with its line and mended by its fix`() = workshop(mainOf("Motor.A.forward()")) { workshop ->
        workshop.compilePrograms()
        assertEquals(WorkshopStatus.HasErrors(line = 4), workshop.state.status)
        workshop.handle(RunEvent.RunPressed)
        assertTrue(workshop.state.programs.errorPointedOut)
        workshop.handle(ProgramEvent.FixApplied(workshop.state.diagnostics.single()))
        workshop.compilePrograms()
        assertEquals(emptyList(), workshop.state.diagnostics)
        assertContains(workshop.state.programText, "Motor.A.forward();")
    }

    @Test
    fun `a fix that is pressed before the program was read again is made where its text is now`() =
        workshop(mainOf("Motor.A.forward()")) { workshop ->
            workshop.compilePrograms()
            workshop.handle(
                ProgramEvent.ProgramEdited("// first\n" + workshop.state.programText.replace("Motor.A", "  Motor.A")),
            )
            workshop.handle(ProgramEvent.FixApplied(workshop.state.programs.notes.single().diagnostic))
            assertContains(workshop.state.programText, "  Motor.A.forward();\n")
            assertContains(workshop.state.programText, "// first\n")
            assertEquals(emptyList(), workshop.state.programs.notes)
            workshop.compilePrograms()
            assertEquals(WorkshopStatus.Ready, workshop.state.status)
        }

    @Test
    fun `a fix of a text that was changed since is made once the program was read, which is at once`() =
        workshop(mainOf("Motor.A.forward()")) { workshop ->
            workshop.compilePrograms()
            workshop.handle(
                ProgramEvent.ProgramEdited(workshop.state.programText.replace("forward()", "forward() // go")),
            )
            val changed = workshop.state.programText
            workshop.handle(ProgramEvent.FixApplied(workshop.state.programs.notes.single().diagnostic))
            assertEquals(changed, workshop.state.programText)
            assertEquals(CompileStatus.COMPILING, workshop.state.programs.compileStatus)
            workshop.compilePrograms()
            assertContains(workshop.state.programText, "Motor.A.forward(); // go")
            workshop.compilePrograms()
            assertEquals(WorkshopStatus.Ready, workshop.state.status)
        }

    @Test
    fun `a fix that does not fit any more is not made, and that is said`() =
        workshop(mainOf("Motor.A.forward()")) { workshop ->
            workshop.compilePrograms()
            val diagnostic = workshop.state.diagnostics.single()
            workshop.handle(ProgramEvent.ProgramEdited(workshop.state.programText.replace("forward()", "forward();")))
            val mended = workshop.state.programText
            workshop.handle(ProgramEvent.FixApplied(diagnostic))
            workshop.compilePrograms()
            assertEquals(mended, workshop.state.programText)
            assertEquals(Notice.FixOutdated, workshop.state.notice)
            workshop.handle(WorkshopEvent.NoticeDismissed)
            workshop.handle(ProgramEvent.FixApplied(diagnostic))
            assertEquals(mended to Notice.FixOutdated, workshop.state.programText to workshop.state.notice)
        }

    @Test
    fun `a program of several files tells which file it is in`() {
        val helper =
            SourceFile(
                "Helper.java",
                "class Helper {\n    static int half(int number) {\n        return number / 0;\n    }\n}\n",
            )
        val program = Program.of(mainOf("LCD.showNumber(Helper.half(8));").files + helper)
        workshop(program) { workshop ->
            workshop.compilePrograms()
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1000)
            val status = workshop.state.status as WorkshopStatus.Failed
            assertEquals("Helper.java" to 3, status.file to status.line)
            workshop.handle(ProgramEvent.FileChosen(1))
            workshop.handle(ProgramEvent.ProgramEdited("class Helper { hop }"))
            workshop.compilePrograms()
            assertContains(workshop.state.diagnostics.map { it.file }, "Helper.java")
        }
    }

    @Test
    fun `where a brick calculates otherwise the pupil is told`() = workshop(largeDivisor) { workshop ->
        workshop.compilePrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        assertEquals(listOf(4), workshop.state.shownProgramRun.warnings.map { it.sourceLine })
        workshop.handle(ProgramEvent.ProgramEdited(workshop.state.programText + "\n"))
        assertEquals(emptyList(), workshop.state.shownProgramRun.warnings)
    }

    @Test
    fun `a new Java program can run as it is`() = workshop(firstDrive) { workshop ->
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        assertEquals("Program.java", workshop.state.programName)
        workshop.handle(ProgramEvent.FileAdded)
        assertEquals(listOf("Program.java", "Helper.java"), workshop.state.program.files.map { it.name })
        workshop.compilePrograms()
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1000)
        assertTrue(workshop.state.running)
        assertEquals(1, workshop.state.session.brick.selectedSlot)
    }

    @Test
    fun `Prgm on the brick chooses among the programs, in whatever language`() =
        workshop(Program.of("beep.robo", "beep"), firstDrive) { workshop ->
            workshop.compilePrograms()
            tap(workshop, BrickButton.PRGM)
            tap(workshop, BrickButton.RUN)
            workshop.advance(1000)
            assertTrue(workshop.state.running)
            assertEquals(0, workshop.state.shownProgramRun.runningLine)
            workshop.handle(ProgramEvent.ProgramChosen(1))
            assertEquals(sleepingLine, workshop.state.shownProgramRun.runningLine)
        }

    @Test
    fun `five programs fit, and one that was closed can be brought back`() = workshop(firstDrive) { workshop ->
        repeat(6) { workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG)) }
        assertEquals(5, workshop.state.programs.programs.size)
        assertEquals(
            workshop.state.programs.programs.size,
            workshop.state.programs.programs.map { it.name }.toSet().size,
        )
        workshop.handle(ProgramEvent.ProgramChosen(0))
        workshop.handle(ProgramEvent.ProgramClosed(0))
        assertEquals("program.robo", workshop.state.programName)
        workshop.handle(ProgramEvent.ProgramReopened)
        assertEquals(firstDrive, workshop.state.program)
        assertNull(workshop.state.programs.closed)
        repeat(6) { workshop.handle(ProgramEvent.ProgramClosed(0)) }
        assertEquals(1, workshop.state.programs.programs.size)
    }

    @Test
    fun `a class of a program can be taken away and brought back, but not the last one`() =
        workshop(firstDrive) { workshop ->
            workshop.handle(ProgramEvent.FileAdded)
            val both = workshop.state.program
            workshop.handle(ProgramEvent.FileClosed(0))
            assertEquals(listOf(both.files[1]), workshop.state.program.files)
            assertEquals(both.files[0].name, workshop.state.programs.closed)
            workshop.handle(ProgramEvent.FileClosed(0))
            assertEquals(1, workshop.state.program.files.size)
            workshop.handle(ProgramEvent.ProgramReopened)
            assertEquals(both, workshop.state.program)
            assertEquals(0, workshop.state.programs.shownFile)
            workshop.handle(ProgramEvent.FileClosed(1))
            workshop.handle(ProgramEvent.FileAdded)
            assertFalse(workshop.state.programs.canReopen, "there is a class of this name again")
        }

    private val paperSample get() = mainOf("Motor.A.forward(); Motor.C.forward();")
    private val largeDivisor get() = mainOf("int a = 70000; LCD.showNumber(200000 / a);")

    private fun mainOf(body: String) = Program.of(
        "Mine.java",
        "import josx.platform.rcx.*;\npublic class Mine {\n    public static void main(String[] args) {\n        " +
            "$body\n    }\n}\n",
    )

    private fun tap(workshop: Workshop, button: BrickButton) {
        workshop.handle(RunEvent.ButtonPressed(button))
        workshop.advance(100)
        workshop.handle(RunEvent.ButtonReleased(button))
        workshop.advance(100)
    }

    private fun workshop(vararg programs: Program, check: suspend (Workshop) -> Unit) = runBlocking {
        val workshop = openWorkshop(programs.toList())
        check(workshop)
        workshop.close()
    }
}
