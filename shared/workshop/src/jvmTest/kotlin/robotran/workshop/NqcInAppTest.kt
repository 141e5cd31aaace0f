package robotran.workshop

import kotlinx.coroutines.runBlocking
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.language.ShownLanguage
import robotran.languagesupport.SourceFile
import robotran.legofirmware.image.toBytes
import robotran.programs.Program
import robotran.programs.ProgramCompiler
import robotran.programs.ProgramResult
import robotran.programs.SourceLine
import robotran.programs.firmwareImage
import robotran.projects.PENBOT_TARGET
import robotran.projects.ProgramView
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.workshop.documents.Machine
import robotran.workshop.event.BlockEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examples
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.WorkshopStatus
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A pupil works with NQC and with what LEGO's firmware runs. */
class NqcInAppTest {
    private val counting = Program.of("counting.nqc", COUNTING)

    private fun workshop(vararg programs: Program, check: suspend (Workshop) -> Unit) = runBlocking {
        val workshop = openWorkshop(programs.toList())
        workshop.compilePrograms()
        check(workshop)
        workshop.close()
    }

    private fun example(name: String) = Program.of(name, ProgramLanguage.NQC.examples.getValue(name))

    private fun lineWith(text: String) = COUNTING.lines().indexOfFirst { text in it } + 1

    @Test
    fun `a new program in NQC drives, and so does one in assembly`() = workshop { workshop ->
        for (language in listOf(ProgramLanguage.NQC, ProgramLanguage.LASM)) {
            workshop.handle(ProgramEvent.NewProgramRequested(language))
            assertEquals("program${language.extension}", workshop.state.programName)
            assertEquals(emptyList(), workshop.state.diagnostics)
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(4_000)
            assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        }
    }

    @Test
    fun `every example runs`() {
        for (name in ProgramLanguage.NQC.examples.keys) {
            workshop(example(name)) { workshop ->
                assertEquals(emptyList(), workshop.state.diagnostics, name)
                workshop.handle(RunEvent.RunPressed)
                workshop.advance(500)
                assertTrue(workshop.state.running, name)
            }
        }
    }

    @Test
    fun `a mistake is told at once with its line and mended by its fix`() = workshop(counting) { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited(COUNTING.replace("OnFwd", "OnFwdd")))
        assertEquals(WorkshopStatus.HasErrors(lineWith("OnFwd")), workshop.state.status)
        workshop.handle(ProgramEvent.FixApplied(workshop.state.diagnostics.first { it.fix != null }))
        assertEquals(emptyList(), workshop.state.diagnostics)
        assertEquals(COUNTING, workshop.state.programText)
    }

    @Test
    fun `it stops at its breakpoint, and shows its tasks and variables by name`() = workshop(counting) { workshop ->
        val line = lineWith("rounds += 1")
        workshop.handle(ProgramEvent.BreakpointToggled(line))
        workshop.handle(RunEvent.RunPressed)
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        workshop.advance(1_500)
        assertEquals(WorkshopStatus.Paused(line), workshop.state.status)
        assertEquals(line, workshop.state.shownProgramRun.runningLine)
        val shown = workshop.state.run.drawer.variables
        assertEquals(setOf("main", "music"), shown.threads.map { it.name }.toSet())
        val variables = shown.scopes.flatMap { it.variables }
        assertEquals("0", variables.single { it.name == "rounds" }.value)
        workshop.handle(RunEvent.PausePressed)
        workshop.advance(2_000)
        val later = workshop.state.run.drawer.variables.scopes.flatMap { it.variables }
        assertEquals("1", later.single { it.name == "rounds" }.value)
    }

    @Test
    fun `while a task waits its Wait is marked, and the log keeps the lines of the calls`() =
        workshop(example("two-things.nqc")) { workshop ->
            fun lineWith(text: String) = workshop.state.programText.lines().indexOfFirst { text in it } + 1
            workshop.handle(RunEvent.RunPressed)
            workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
            workshop.advance(300)
            repeat(4) {
                assertEquals(lineWith("Wait(150)"), workshop.state.shownProgramRun.runningLine)
                val main = workshop.state.run.drawer.variables.threads.single { it.name == "main" }
                assertEquals(lineWith("Wait(150)"), main.callStack.single().sourceLine)
                workshop.advance(300)
            }
            workshop.advance(200)
            assertEquals(lineWith("Wait(45)"), workshop.state.shownProgramRun.runningLine)
            workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
            val reversed = workshop.state.run.drawer.log.entries.first { it.meaning == "motor A backward 7" }
            assertEquals(lineWith("OnRev"), reversed.sourceLine)
        }

    @Test
    fun `what it includes stops in its own file, and is renamed everywhere`() {
        val main = SourceFile("drive.nqc", "#include \"steps.nqh\"\n\ntask main()\n{\n    step();\n}\n")
        val header = SourceFile("steps.nqh", "void step()\n{\n    OnFwd(OUT_A);\n    Wait(50);\n    Off(OUT_A);\n}\n")
        workshop(Program.of(listOf(main, header))) { workshop ->
            assertEquals(emptyList(), workshop.state.diagnostics)
            workshop.handle(ProgramEvent.FileChosen(1))
            workshop.handle(ProgramEvent.BreakpointToggled(4))
            workshop.handle(ProgramEvent.FileChosen(0))
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1_000)
            assertEquals(WorkshopStatus.Paused(4), workshop.state.status)
            assertEquals("steps.nqh", workshop.state.file.name)
            workshop.handle(ProgramEvent.FileRenamed(1, "moves"))
            assertEquals(listOf("drive.nqc", "moves.nqh"), workshop.state.program.files.map { it.name })
            assertContains(workshop.state.program.files.first().text, "#include \"moves.nqh\"")
            assertEquals(emptyList(), workshop.state.diagnostics)
        }
    }

    @Test
    fun `one more file is included, and can be closed and come back`() = workshop(counting) { workshop ->
        workshop.handle(ProgramEvent.FileAdded)
        assertEquals(listOf("counting.nqc", "helper.nqh"), workshop.state.program.files.map { it.name })
        assertEquals("helper.nqh", workshop.state.file.name)
        workshop.handle(ProgramEvent.ProgramEdited("void help()\n{\n    PlaySound(3);\n}\n"))
        workshop.handle(ProgramEvent.FileChosen(0))
        workshop.handle(ProgramEvent.ProgramEdited(workshop.state.programText.replace("start music;", "help();")))
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(ProgramEvent.FileClosed(1))
        assertTrue(workshop.state.diagnostics.isNotEmpty())
        workshop.handle(ProgramEvent.ProgramReopened)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `it is shown in assembly, line for line, and never in blocks or in Java`() = workshop(counting) { workshop ->
        workshop.handle(BlockEvent.ViewChosen(ProgramView.BLOCKS))
        assertEquals(ProgramView.TEXT, workshop.state.programs.view)
        assertEquals(listOf(ShownLanguage.LASM), workshop.state.programs.translationKinds)
        workshop.handle(ProgramEvent.TranslationShown(true))
        val assembly = assertNotNull(workshop.state.programs.translation)
        val lines = assembly.text.lines()
        val ofWait = assembly.linesOf("counting.nqc", lineWith("Wait(100)")).map { lines[it - 1].trim() }
        assertEquals(listOf("wait\t2, 100"), ofWait)
        val place = assembly.linesOf("counting.nqc", lineWith("Wait(100)")).single()
        assertEquals(SourceLine("counting.nqc", lineWith("Wait(100)")), assembly.originOf(place))
        // The assembly is a program of its own, which makes the same image.
        workshop.handle(ProgramEvent.ProgramAdded(Program.of(assembly.fileName, assembly.text)))
        assertEquals(emptyList(), workshop.state.diagnostics)
        assertContentEquals(imageOf(COUNTING), imageOf(workshop.state.program))
    }

    @Test
    fun `Robolang is shown in NQC, with what is different`() = workshop { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("forward 20\nshow \"hello\"\nbeep\n"))
        workshop.handle(ProgramEvent.TranslationShown(true, ShownLanguage.NQC))
        val translation = assertNotNull(workshop.state.programs.translation)
        assertContains(translation.text, "task main()")
        assertEquals(listOf(2), translation.notes.map { it.line }.distinct())
        assertTrue(translation.linesOf(workshop.state.file.name, 3).isNotEmpty())
        workshop.handle(SettingsEvent.SettingsChanged(workshop.settings.copy(language = Language.GERMAN)))
        val german = assertNotNull(workshop.state.programs.translation).notes.first().message
        assertTrue(german != translation.notes.first().message, german)
        workshop.handle(ProgramEvent.ProgramEdited("forwrd 20\n"))
        assertEquals(ShownLanguage.NQC, assertNotNull(workshop.state.programs.translation).language)
        assertEquals(false, workshop.state.programs.isTranslated)
    }

    @Test
    fun `an image becomes assembly, and goes out as the same image`() = runBlocking {
        val machine = Machine()
        val workshop = machine.window()
        val image = imageOf(COUNTING)
        workshop.handle(DocumentEvent.FilesBrought(listOf(OpenedFile("robot.rcx", image))))
        assertEquals("robot.lasm", workshop.state.programName)
        assertContains(workshop.state.programText, "; Var 0 = rounds")
        assertEquals(emptyList(), workshop.state.diagnostics)
        assertTrue(workshop.state.document.hasFirmwareImage)
        machine.files.location = "out"
        workshop.handle(DocumentEvent.KitRequested)
        assertEquals("robot.rcx", machine.files.suggestion)
        assertContentEquals(image, machine.files.disk["out"])
        workshop.handle(DocumentEvent.ProgramFileRequested)
        assertEquals("robot.lasm", machine.files.suggestion)
        val file = assertIs<ProjectFileResult.Success>(readProject(writeProject(workshop.project), Language.ENGLISH))
        assertEquals(workshop.project, file.project)
        workshop.close()
    }

    @Test
    fun `a project keeps NQC, and it goes out as it is and as an image`() = runBlocking {
        val machine = Machine()
        val workshop = machine.window()
        workshop.handle(ProgramEvent.ProgramAdded(counting))
        val file = assertIs<ProjectFileResult.Success>(readProject(writeProject(workshop.project), Language.ENGLISH))
        assertEquals(workshop.project, file.project)
        assertEquals(ProgramLanguage.NQC, file.project.robots.first().programs.last().language)
        machine.files.location = "out"
        workshop.handle(DocumentEvent.ProgramFileRequested)
        assertEquals("counting.nqc" to COUNTING, machine.files.suggestion to machine.written())
        workshop.handle(DocumentEvent.KitRequested)
        assertContentEquals(imageOf(COUNTING), machine.files.disk["out"])
        workshop.close()
    }

    @Test
    fun `the datalog stays when the program has ended, and is saved as a table`() = runBlocking {
        val machine = Machine()
        val workshop = machine.window()
        workshop.handle(ProgramEvent.ProgramEdited(""))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("log.nqc", LOGGING)))
        workshop.handle(RunEvent.DrawerChosen(DrawerTab.VARIABLES))
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(2_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertEquals(listOf(7, 42), workshop.state.run.drawer.variables.datalog.map { it.value })
        val kept = workshop.state.run.drawer.variables.scopes.single()
        assertEquals("log.nqc" to listOf("x" to "42"), kept.name to kept.variables.map { it.name to it.value })
        machine.files.location = "out"
        workshop.handle(RunEvent.DatalogSaved)
        assertEquals("log.nqc datalog.csv", machine.files.suggestion)
        assertEquals("number,source,value\r\n1,x,7\r\n2,x,42\r\n", machine.written())
        workshop.close()
    }

    @Test
    fun `what the firmware does in silence is told, at its line if it has one`() =
        workshop(Program.of("lost.nqc", LOSING)) { workshop ->
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(1_000)
            val warnings = workshop.state.shownProgramRun.warnings
            assertContains(warnings.single { it.sourceLine == 4 }.message, "There is no datalog")
            workshop.handle(RunEvent.DrawerChosen(DrawerTab.LOG))
            val lines = workshop.state.run.drawer.log.entries.filter { it.meaning == "motor A forward 7" }
            assertEquals(listOf(5), lines.map { it.sourceLine }.distinct())
        }

    private fun Machine.written() = files.disk.getValue("out").decodeToString()

    @Test
    fun `on an NXT it is told that it needs an RCX, and a touch changes the robot`() = workshop(counting) { workshop ->
        val robot = workshop.state.programs.shownRobot
        workshop.handle(WorldEditEvent.PenbotChosen(robot, BrickKind.NXT))
        workshop.compilePrograms()
        assertEquals(BrickKind.RCX, workshop.state.programs.otherBrick)
        workshop.handle(WorldEditEvent.PenbotChosen(robot, BrickKind.RCX))
        workshop.compilePrograms()
        assertNull(workshop.state.programs.otherBrick)
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `help knows NQC, and the layout is that of NQC`() = workshop(counting) { workshop ->
        for (word in listOf("OnFwd", "repeat")) {
            workshop.handle(LearningEvent.HelpRequested(COUNTING, COUNTING.indexOf(word) + 1))
            assertEquals(word, workshop.state.learning.help.found?.word)
        }
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("wait.lasm", "\ttask\t0\n\twait\t2, 100\n\tendt\n")))
        workshop.handle(
            LearningEvent.HelpRequested(workshop.state.programText, workshop.state.programText.indexOf("wait")),
        )
        assertEquals(listOf("wait source, argument"), workshop.state.learning.help.found?.forms)
        workshop.handle(ProgramEvent.ProgramChosen(0))
        workshop.handle(ProgramEvent.ProgramEdited(COUNTING.replace("    ", "")))
        workshop.handle(ProgramEvent.Formatted)
        assertEquals(COUNTING, workshop.state.programText)
    }

    @Test
    fun `the buttons of the brick start and stop it, and it is started with another firmware beside it`() =
        workshop(Program.of("beep.robo", "repeat forever\n  beep\nend\n"), counting) { workshop ->
            workshop.handle(ProgramEvent.ProgramChosen(1))
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(500)
            assertTrue(workshop.state.running)
            for (running in listOf(false, true)) {
                workshop.handle(RunEvent.ButtonPressed(BrickButton.RUN))
                workshop.advance(200)
                workshop.handle(RunEvent.ButtonReleased(BrickButton.RUN))
                workshop.advance(200)
                assertEquals(running, workshop.state.running)
            }
            workshop.handle(ProgramEvent.ProgramChosen(0))
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(500)
            assertTrue(workshop.state.running)
        }

    private fun imageOf(nqc: String) = imageOf(Program.of("counting.nqc", nqc))

    private fun imageOf(program: Program): ByteArray {
        val files = program.files.map { SourceFile(it.name, it.text) }
        val result = ProgramCompiler(
            PENBOT_TARGET,
            language = Language.ENGLISH,
        ).compileNow(Program(program.name, program.language, files))
        return checkNotNull(assertIs<ProgramResult.Success>(result).firmwareImage).toBytes()
    }

    private companion object {
        val COUNTING = """
            int rounds = 0;

            task main()
            {
                start music;
                repeat (3)
                {
                    OnFwd(OUT_A + OUT_C);
                    Wait(100);
                    rounds += 1;
                }
                Off(OUT_A + OUT_C);
                stop music;
            }

            task music()
            {
                while (true)
                {
                    PlayTone(440, 10);
                    Wait(50);
                }
            }
        """.trimIndent() + "\n"

        val LOSING = """
            int x = 7;
            task main()
            {
                AddToDatalog(x);
                OnFwd(OUT_A);
            }
        """.trimIndent() + "\n"

        val LOGGING = """
            int x = 7;

            task main()
            {
                CreateDatalog(5);
                AddToDatalog(x);
                x = 42;
                AddToDatalog(x);
            }
        """.trimIndent() + "\n"
    }
}
