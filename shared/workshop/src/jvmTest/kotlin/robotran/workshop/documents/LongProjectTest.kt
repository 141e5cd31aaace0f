package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.language.ProgramLanguage
import robotran.programs.Program
import robotran.projects.Project
import robotran.projects.ProjectLimits
import robotran.projects.ProjectProgram
import robotran.projects.ProjectRobot
import robotran.projects.writeProject
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.AutosaveError
import robotran.workshop.state.Notice
import robotran.workshop.text
import robotran.world.file.BuiltInWorlds
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** What can be opened can be saved, and what could not be saved is refused before it is there. */
class LongProjectTest {
    private val machine = Machine()

    @Test
    fun `a project with as many lines as a program may have is opened, edited and saved`() {
        val text = "//\n".repeat(ProjectLimits.MAXIMUM_LINES - 2) + "beep\n"
        val window = machine.window(OpenRequest.OfFiles(listOf(OpenedFile("long.robotran", fileOf(text)))))
        assertEquals(text, window.state.programText)
        assertTrue(runBlocking { window.saveDocumentNow() })
        window.write(text.replace("beep", "beep\n"))
        assertNull(window.state.document.error)
        machine.files.location = "/home/long.robotran"
        window.handle(DocumentEvent.SaveAsRequested)
        assertEquals(Notice.FileSaved("long.robotran"), window.state.notice)
        assertEquals(
            window.state.programText,
            machine.afterKill().also { it.marks.times.clear() }.window().state.programText,
        )
    }

    @Test
    fun `programs that together are too long to be saved are refused as they come`() {
        val window = machine.window()
        val long = "// \"\"\"\n".repeat(25_000)
        var refused = 0
        for (number in 1..5) {
            window.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.ROBOLANG))
            window.edit(long)
            if (window.state.programText != long) refused++
            window.keep()
            assertNull(window.state.document.error, "what is there is saved")
        }
        assertTrue(refused > 0)
        assertEquals(Notice.ProjectTooLong, window.state.notice)
        window.edit("beep")
        assertEquals("beep", window.state.programText, "it can always become shorter")
    }

    @Test
    fun `a store that does not answer is told before there is anything to lose, and the work goes on`() {
        machine.store.isAnswering = false
        val window = machine.window()
        assertEquals(AutosaveError.NoAnswer, window.state.document.error)
        window.write("forward 7")
        assertEquals("forward 7", window.state.programText)
        machine.files.location = "/home/saved.robotran"
        window.handle(DocumentEvent.SaveAsRequested)
        assertTrue("forward 7" in machine.files.disk.getValue("/home/saved.robotran").decodeToString())
        machine.store.isAnswering = true
        window.write("forward 8")
        assertNull(window.state.document.error)
    }

    private fun Workshop.edit(text: String) =
        handle(ProgramEvent.DraftChanged(TextDocument(text).withCaret(text.length), EditKind.OTHER))

    private fun fileOf(text: String): ByteArray {
        val world = BuiltInWorlds.plain
        val program = ProjectProgram(Program("a.robo", ProgramLanguage.ROBOLANG, text))
        return writeProject(Project(world, listOf(ProjectRobot(world.robots.first().name, listOf(program)))))
            .encodeToByteArray()
    }
}
