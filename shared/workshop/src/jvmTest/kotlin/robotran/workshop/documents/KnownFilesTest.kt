package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** A file that My work knows: it is opened again, edited, changed elsewhere, or open in another window. */
class KnownFilesTest {
    private val machine = Machine()
    private val file = projectFile("forward 1")

    @Test
    fun `the same file finds its entry in My work however often it is opened`() {
        repeat(3) { machine.open().leave() }
        val window = machine.open()
        assertEquals("forward 1", window.state.programText)
        assertEquals(listOf("maze.robotran"), window.projects().map { it.entry.fileName })
        window.handle(DocumentEvent.FilesBrought(listOf(file)))
        assertEquals(1, window.projects().size)
    }

    @Test
    fun `what is newer in My work than in its file is asked about, with both times`() {
        edited()
        machine.files.changed = 120_000
        val window = machine.open()
        val asked = assertIs<DocumentDialog.NewerInMyWork>(window.state.document.dialog)
        assertEquals(DocumentDialog.NewerInMyWork("maze.robotran", "16 min", "2 min"), asked)
        window.handle(DocumentEvent.WorkOrFileChosen(isWork = true))
        assertEquals("forward 12", window.state.programText)
        assertNull(window.state.document.dialog)
        assertEquals(1, window.projects().size)
    }

    @Test
    fun `the file is opened as it is if that is chosen, and the newer work stays`() {
        edited()
        val window = machine.open()
        window.handle(DocumentEvent.WorkOrFileChosen(isWork = false))
        assertEquals("forward 1", window.state.programText)
        window.leave()
        val next = machine.open()
        assertEquals("forward 1", next.state.programText, "it is not asked again")
        val texts = next.projects().map { work ->
            next.handle(DocumentEvent.SavedProjectChosen(work.entry.id))
            next.state.programText
        }
        assertEquals(setOf("forward 1", "forward 12"), texts.toSet())
    }

    @Test
    fun `a file that another program has changed is opened as its entry in My work`() {
        machine.open().leave()
        val window = machine.open(projectFile("forward 2"))
        assertEquals("forward 2", window.state.programText)
        assertEquals(1, window.projects().size)
        window.handle(DocumentEvent.FilesBrought(listOf(projectFile("forward 3"))))
        assertEquals("forward 3", window.state.programText)
        assertEquals(1, window.projects().size)
    }

    @Test
    fun `a second window on the same file warns, also if the first has restored it`() {
        machine.open().leave()
        val first = machine.window()
        assertEquals("forward 1", first.state.programText)
        assertEquals(Notice.FileOpenElsewhere("maze.robotran"), machine.open().state.notice)
    }

    @Test
    fun `files that were used last are offered, each once, and open what My work has of them`() {
        edited()
        val window = machine.open(projectFile("forward 5", "town.robotran"))
        val recent = window.state.document.recentFiles
        assertEquals(listOf("maze.robotran"), recent.map { it.name })
        window.handle(DocumentEvent.SavedProjectChosen(recent.single().id))
        assertEquals("forward 12", window.state.programText)
        assertEquals(listOf("town.robotran"), window.state.document.recentFiles.map { it.name })
    }

    /** The file is opened, edited and left, not saved to the file. */
    private fun edited() {
        val window = machine.open()
        window.write("forward 12")
        window.leave()
    }

    private fun Machine.open(file: OpenedFile = this@KnownFilesTest.file) = window(OpenRequest.OfFiles(listOf(file)))

    private fun Workshop.leave() {
        runBlocking { closeDocument() }
        close()
        machine.clock.now += 1_000
    }
}
