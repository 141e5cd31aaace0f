package robotran.workshop

import kotlinx.coroutines.delay
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeout
import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.projects.writeProject
import robotran.robotediting.RobotEdit
import robotran.workshop.documents.Machine
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.examples.examplesFor
import robotran.workshop.state.Notice
import robotran.workshop.state.WorkshopStatus
import robotran.world.ReadyRobots
import robotran.world.RobotPlacement
import robotran.worldediting.WorldEdit
import java.io.ByteArrayInputStream
import java.util.zip.ZipInputStream
import kotlin.math.abs
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** A pupil works with a robot that has an NXT. */
class NxtInAppTest {
    private val square = Program.of("Square.java", example("Square.java"))

    private fun example(name: String) = ProgramLanguage.JAVA.examplesFor(BrickKind.NXT).getValue(name)

    private fun workshop(vararg programs: Program, check: suspend (Workshop) -> Unit) = runBlocking {
        val workshop = openWorkshop(programs.toList())
        workshop.compilePrograms()
        check(workshop)
        workshop.close()
    }

    private val Workshop.brick: BrickKind get() = state.programs.brick

    private fun Workshop.use(brick: BrickKind) = handle(WorldEditEvent.PenbotChosen(state.programs.shownRobot, brick))

    @Test
    fun `a new project with an NXT runs the first program`() = workshop { workshop ->
        workshop.handle(DocumentEvent.NewWithBrick(BrickKind.NXT))
        workshop.compilePrograms()
        assertEquals(BrickKind.NXT, workshop.brick)
        assertFalse(workshop.state.document.canSend)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(20_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(abs(workshop.state.session.ink.lengthCentimetres - 80) < 3)
    }

    @Test
    fun `a new program in Java is one for the brick of the robot`() = workshop { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.JAVA))
        assertContains(workshop.state.programText, "import lejos.nxt.*;")
        workshop.handle(ProgramEvent.FileAdded)
        assertContains(workshop.state.programText, "import lejos.nxt.*;")
        workshop.compilePrograms()
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(4_000)
        assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
        assertTrue(workshop.state.session.robot.pose.x > workshop.state.world.start.x + 20)
    }

    @Test
    fun `a program for the other brick is told, and a touch changes the robot`() = workshop(square) { workshop ->
        assertEquals(BrickKind.NXT, workshop.state.programs.otherBrick)
        workshop.use(BrickKind.NXT)
        workshop.compilePrograms()
        assertNull(workshop.state.programs.otherBrick)
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.use(BrickKind.RCX)
        workshop.compilePrograms()
        assertEquals(BrickKind.NXT, workshop.state.programs.otherBrick)
        assertEquals(BrickKind.RCX, workshop.brick)
    }

    @Test
    fun `Robolang with words of an NXT is told, other mistakes are not`() = workshop { workshop ->
        workshop.handle(ProgramEvent.ProgramEdited("when distance < 20\nbeep\n"))
        assertNull(workshop.state.programs.otherBrick)
        workshop.handle(ProgramEvent.ProgramEdited("wait until distance < 20\nbeep\n"))
        assertEquals(BrickKind.NXT, workshop.state.programs.otherBrick)
        workshop.use(BrickKind.NXT)
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(ProgramEvent.ProgramEdited("robot\n  brick rcx\nend\nbeep\n"))
        assertEquals(BrickKind.RCX, workshop.state.programs.otherBrick)
    }

    @Test
    fun `the change of the robot is a step that the world editor takes back`() = workshop { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.handle(WorldEditEvent.EditorOpened)
        workshop.handle(WorldEditEvent.Edited(WorldEdit.Undo))
        workshop.handle(WorldEditEvent.EditorClosed)
        assertEquals(BrickKind.RCX, workshop.brick)
    }

    @Test
    fun `the notice takes the change of the robot back until the robot is changed again`() = workshop { workshop ->
        val before = workshop.state.world
        workshop.use(BrickKind.NXT)
        assertEquals(Notice.RobotReplaced("yellow", ReadyRobots.NXT_PENBOT), workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        assertEquals(before, workshop.state.world)
        assertNull(workshop.state.notice)
        workshop.use(BrickKind.NXT)
        workshop.handle(RobotEditEvent.BenchOpened())
        workshop.handle(RobotEditEvent.Edited(RobotEdit.Replace(ReadyRobots.SUMO)))
        workshop.handle(RobotEditEvent.BenchClosed)
        assertNull(workshop.state.notice)
        assertEquals(ReadyRobots.SUMO, workshop.state.programs.robot.description)
    }

    @Test
    fun `robots with different bricks have programs of their own`() = workshop { workshop ->
        val world = workshop.state.world
        val second = RobotPlacement(world.start.copy(y = 15.0), "blue", description = ReadyRobots.SUMO)
        workshop.services.editor.openProject(Project(world.copy(robots = world.robots + second)))
        workshop.compilePrograms()
        workshop.handle(ProgramEvent.RobotChosen("blue"))
        assertEquals(BrickKind.NXT, workshop.brick)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Hello.java", example("Hello.java"))))
        workshop.compilePrograms()
        assertEquals(emptyList(), workshop.state.diagnostics)
        workshop.handle(ProgramEvent.RobotChosen(workshop.state.programs.robots.first().name))
        assertEquals(BrickKind.RCX, workshop.brick)
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(1_000)
        assertTrue(workshop.state.running)
    }

    @Test
    fun `a project keeps the robot and its programs`() = workshop(square) { workshop ->
        workshop.use(BrickKind.NXT)
        val file = assertIs<ProjectFileResult.Success>(readProject(writeProject(workshop.project), Language.ENGLISH))
        assertEquals(workshop.project, file.project)
        assertEquals(BrickKind.NXT, file.project.world.robots.first().description.brick)
    }

    @Test
    fun `a program for an NXT goes out as a kit for its own tools`() = runBlocking {
        val machine = Machine()
        val workshop = machine.window()
        workshop.use(BrickKind.NXT)
        assertTrue(machine.kit(workshop).getValue("Square/build.xml").contains("nxjupload"))
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("Hello.java", example("Hello.java"))))
        val files = machine.kit(workshop)
        assertEquals(example("Hello.java"), files["Hello/Hello.java"])
        assertContains(files.getValue("Hello/upload.sh"), "nxjc -encoding UTF-8 -d . Hello.java")
        workshop.close()
    }

    /** The files of the kit for the shown program. Java is compiled in a thread of its own, so this waits for it. */
    private suspend fun Machine.kit(workshop: Workshop): Map<String, String> {
        files.location = "kit"
        workshop.handle(WorkshopEvent.NoticeDismissed)
        workshop.handle(DocumentEvent.KitRequested)
        withTimeout(60_000) {
            while (workshop.state.notice == null) delay(5)
        }
        assertEquals(Notice.FileSaved("kit"), workshop.state.notice)
        val zip = ZipInputStream(ByteArrayInputStream(files.disk.getValue("kit")))
        return generateSequence { zip.nextEntry }.associate { it.name to zip.readBytes().decodeToString() }
    }

    @Test
    fun `help knows the brick`() = workshop(square) { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.compilePrograms()
        val text = square.files.single().text
        workshop.handle(LearningEvent.HelpRequested(text, text.indexOf("rotateTo") + 1))
        assertEquals("Motor.rotateTo", workshop.state.learning.help.found?.word)
        workshop.handle(LearningEvent.HelpRequested(text, text.indexOf("travel(") + 1))
        assertEquals("DifferentialPilot.travel", workshop.state.learning.help.found?.word)
        workshop.handle(LearningEvent.ExampleTried)
        workshop.compilePrograms()
        assertContains(workshop.state.programText, "import lejos.nxt.*;")
        assertEquals(emptyList(), workshop.state.diagnostics)
    }

    @Test
    fun `the translation of Robolang is Java for the brick`() = workshop { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.compilePrograms()
        workshop.handle(ProgramEvent.TranslationShown(true))
        assertContains(assertNotNull(workshop.state.programs.translation).text, "import lejos.nxt.")
        workshop.use(BrickKind.RCX)
        workshop.compilePrograms()
        assertContains(assertNotNull(workshop.state.programs.translation).text, "import josx.")
    }

    @Test
    fun `what a program writes into files is there in the next run and in the project`() = workshop { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("CountRuns.java", COUNT_RUNS)))
        workshop.compilePrograms()
        assertEquals(emptyList(), workshop.state.diagnostics)
        val counts = (1..2).map {
            workshop.handle(RunEvent.RunPressed)
            workshop.advance(3_000)
            assertEquals(WorkshopStatus.Ended(stopped = false), workshop.state.status)
            val file = workshop.project.robots.single().files.single()
            assertEquals("runs.dat", file.name)
            file.content().toList()
        }
        assertEquals(listOf(listOf<Byte>(1), listOf<Byte>(2)), counts)
        val again = assertIs<ProjectFileResult.Success>(
            readProject(writeProject(workshop.project), Language.ENGLISH),
        ).project
        assertEquals(workshop.project, again)
        assertEquals(listOf<Byte>(1), workshop.replay.robots.single().files.single().content().toList())
    }

    @Test
    fun `a file that is deleted in the menu of the brick is gone from the project`() = workshop { workshop ->
        workshop.use(BrickKind.NXT)
        workshop.handle(ProgramEvent.ProgramAdded(Program.of("CountRuns.java", COUNT_RUNS)))
        workshop.compilePrograms()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(3_000)
        assertEquals(listOf("runs.dat"), workshop.project.robots.single().files.map { it.name })

        fun press(vararg buttons: BrickButton) = buttons.forEach { button ->
            workshop.handle(RunEvent.ButtonPressed(button))
            workshop.advance(100)
            workshop.handle(RunEvent.ButtonReleased(button))
            workshop.advance(100)
        }

        // The menu Files, there the last entry, "Delete file", and "Yes".
        press(BrickButton.RIGHT, BrickButton.ENTER, BrickButton.LEFT, BrickButton.ENTER)
        press(BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals(1, workshop.project.robots.single().files.size, "asked first")
        press(BrickButton.RIGHT, BrickButton.ENTER)
        assertEquals(emptyList(), workshop.project.robots.single().files)
        val again = assertIs<ProjectFileResult.Success>(
            readProject(writeProject(workshop.project), Language.ENGLISH),
        ).project
        assertEquals(emptyList(), again.robots.flatMap { it.files })
    }

    private companion object {
        const val COUNT_RUNS = """import java.io.*;
public class CountRuns {
    public static void main(String[] args) throws IOException {
        File file = new File("runs.dat");
        int runs = 0;
        if (file.exists()) {
            FileInputStream in = new FileInputStream(file);
            runs = in.read();
            in.close();
        }
        FileOutputStream out = new FileOutputStream(file);
        out.write(runs + 1);
        out.close();
    }
}
"""
    }
}
