package robotran.workshop.documents

import kotlinx.coroutines.async
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import robotran.documents.OpenFilesError
import robotran.language.Language
import robotran.language.ProgramLanguage
import robotran.projects.LinkResult
import robotran.projects.ProjectFileResult
import robotran.projects.openLink
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.AutosaveError
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.Notice
import robotran.workshop.text
import java.io.ByteArrayInputStream
import java.util.zip.ZipInputStream
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertNull
import kotlin.test.assertTrue

class DocumentStateHolderTest {
    private val machine = Machine()

    @Test
    fun `what was changed is there again after the app was killed, and that is said`() {
        machine.window().write("forward 7")
        val killed = machine.afterKill().window()
        assertEquals("forward 7", killed.state.programText)
        assertIs<Notice.ProjectRestored>(killed.state.notice)
    }

    @Test
    fun `after an orderly end the work is there again without a word`() {
        val first = machine.window()
        first.write("forward 7")
        runBlocking { assertTrue(first.closeDocument()) }
        val second = machine.window()
        assertEquals("forward 7", second.state.programText)
        assertNull(second.state.notice)
    }

    @Test
    fun `breakpoints are there again, with the work and with its file`() {
        val file = projectFile("beep\nbeep\nbeep")
        val first = machine.window(OpenRequest.OfFiles(listOf(file)))
        first.handle(ProgramEvent.BreakpointToggled(2))
        first.handle(ProgramEvent.BreakpointToggled(3))
        runBlocking { assertTrue(first.closeDocument()) }
        val second = machine.window()
        assertEquals(setOf(2, 3), second.state.programs.breakpoints)
        assertTrue(second.state.document.saved, "the file has no breakpoints")
        runBlocking { assertTrue(second.closeDocument()) }
        assertEquals(setOf(2, 3), machine.window(OpenRequest.OfFiles(listOf(file))).state.programs.breakpoints)
    }

    @Test
    fun `nothing is kept of a window in which nothing was done`() {
        machine.window().keep()
        assertEquals(emptyList(), runBlocking { machine.store.names() })
    }

    @Test
    fun `a second window begins afresh and keeps a work of its own`() {
        machine.window().write("forward 1")
        val second = machine.window()
        assertContains(second.state.programText, "forward 20")
        second.write("forward 2")
        assertEquals(2, machine.projects(second).size)
    }

    @Test
    fun `a work of another window is not opened twice`() {
        machine.window().write("forward 1")
        val second = machine.window()
        val other = machine.projects(second).single()
        second.handle(DocumentEvent.SavedProjectChosen(other.entry.id))
        assertEquals(Notice.ProjectOpenElsewhere("My first work"), second.listNotice)
        assertContains(second.state.programText, "forward 20")
    }

    @Test
    fun `a new work leaves the old one among all works, from where it comes back`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(DocumentEvent.Renamed("Maze"))
        workshop.handle(DocumentEvent.NewRequested)
        assertContains(workshop.state.programText, "forward 20")
        assertEquals("My first work", workshop.state.document.name)
        val kept = machine.projects(workshop).single()
        assertEquals("Maze", kept.entry.name)
        workshop.handle(DocumentEvent.SavedProjectChosen(kept.entry.id))
        assertEquals("forward 7", workshop.state.programText)
        assertEquals("Maze", workshop.state.document.name)
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `a work that was deleted comes back as it was, until another one is deleted`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(DocumentEvent.NewRequested)
        val kept = machine.projects(workshop).single()
        workshop.handle(DocumentEvent.ProjectDeleted(kept.entry.id))
        val list = assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog)
        assertEquals(listOf(kept.entry.id), list.projects?.map { it.entry.id }, "it keeps its place")
        assertEquals(kept.entry.id, list.deleted)
        assertEquals(emptyList(), runBlocking { machine.store.names().filter { it.startsWith("work-") } })
        workshop.handle(DocumentEvent.ProjectDeletionUndone)
        assertEquals(kept.entry, machine.projects(workshop).single().entry)
        workshop.handle(DocumentEvent.SavedProjectChosen(kept.entry.id))
        assertEquals("forward 7", workshop.state.programText)
    }

    @Test
    fun `a work of another window is not deleted`() {
        machine.window().write("forward 1")
        val second = machine.window()
        val other = machine.projects(second).single()
        second.handle(DocumentEvent.ProjectDeleted(other.entry.id))
        assertEquals(Notice.ProjectOpenElsewhere("My first work"), second.listNotice)
        assertEquals(1, machine.projects(second).size)
    }

    @Test
    fun `a work in the list gets another name and keeps its place in time`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(DocumentEvent.NewRequested)
        val kept = machine.projects(workshop).single()
        workshop.handle(DocumentEvent.ProjectRenamingRequested(kept.entry.id))
        assertEquals(kept.entry.id, assertIs<DocumentDialog.ProjectList>(workshop.state.document.dialog).renaming)
        workshop.handle(DocumentEvent.ProjectRenamed("Maze"))
        assertEquals(kept.entry.copy(name = "Maze"), machine.projects(workshop).single().entry)
    }

    @Test
    fun `the open work gets another name in the list, too`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        val kept = machine.projects(workshop).single()
        workshop.handle(DocumentEvent.ProjectRenamingRequested(kept.entry.id))
        workshop.handle(DocumentEvent.ProjectRenamed("Maze"))
        assertEquals("Maze", workshop.state.document.name)
        assertEquals("Maze", machine.projects(workshop).single().entry.name)
    }

    @Test
    fun `a copy has a name of its own, and changes of one leave the other`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        val kept = machine.projects(workshop).single()
        workshop.handle(DocumentEvent.ProjectDuplicated(kept.entry.id))
        val copy = machine.projects(workshop).single { it.entry.id != kept.entry.id }
        assertEquals("My first work 2", copy.entry.name)
        workshop.write("forward 8")
        workshop.handle(DocumentEvent.SavedProjectChosen(copy.entry.id))
        assertEquals("forward 7", workshop.state.programText)
    }

    @Test
    fun `a file that is brought at the start is opened in place of the last work, which stays among all`() {
        machine.window().also { it.write("forward 7") }.close()
        val workshop = machine.window(OpenRequest.OfFiles(listOf(projectFile("beep"))))
        assertEquals("beep", workshop.state.programText)
        assertEquals("maze", workshop.state.document.name)
        assertEquals("maze.robotran", workshop.state.document.fileName)
        assertTrue(workshop.state.document.saved)
        assertEquals(2, machine.projects(workshop).size)
    }

    @Test
    fun `saving writes the file, and a change after that is not saved`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        machine.files.location = "/home/town.robotran"
        workshop.handle(DocumentEvent.SaveRequested)
        assertEquals("My first work.robotran", machine.files.suggestion)
        assertTrue(workshop.state.document.saved)
        assertEquals("town", workshop.state.document.name)
        workshop.write("forward 8")
        assertFalse(workshop.state.document.saved)
        workshop.handle(DocumentEvent.SaveRequested)
        assertTrue(workshop.state.document.saved)
        assertContains(assertNotNull(machine.files.disk["/home/town.robotran"]).decodeToString(), "forward 8")
        assertIs<Notice.FileSaved>(workshop.state.notice)
    }

    @Test
    fun `a file that somebody else has changed is not written over without a question`() {
        val theirs = projectFile("beep beep").bytes
        val workshop = machine.window(OpenRequest.OfFiles(listOf(projectFile("beep"))))
        machine.files.disk["/home/maze.robotran"] = theirs
        workshop.write("forward 1")
        workshop.handle(DocumentEvent.SaveRequested)
        assertEquals(DocumentDialog.ChangedElsewhere("maze.robotran"), workshop.state.document.dialog)
        assertContentEquals(theirs, machine.files.disk["/home/maze.robotran"])
        workshop.handle(DocumentEvent.Answered(DocumentAnswer.GO_ON))
        assertContains(machine.files.disk.getValue("/home/maze.robotran").decodeToString(), "forward 1")
    }

    @Test
    fun `what somebody else has put into the file can be taken`() {
        val workshop = machine.window(OpenRequest.OfFiles(listOf(projectFile("beep"))))
        machine.files.disk["/home/maze.robotran"] = projectFile("buzz").bytes
        workshop.write("forward 1")
        workshop.handle(DocumentEvent.SaveRequested)
        workshop.handle(DocumentEvent.Answered(DocumentAnswer.TAKE_THEIRS))
        assertEquals("buzz", workshop.state.programText)
        assertEquals(2, machine.projects(workshop).size)
    }

    @Test
    fun `two windows on the same file warn`() {
        machine.window(OpenRequest.OfFiles(listOf(projectFile("beep"))))
        val second = machine.window(OpenRequest.OfFiles(listOf(projectFile("beep"))))
        assertIs<Notice.FileOpenElsewhere>(second.state.notice)
    }

    @Test
    fun `a full device is told, costs nothing, and is over when there is room again`() {
        val workshop = machine.window()
        workshop.write("forward 1")
        machine.store.full = true
        workshop.write("forward 2")
        assertEquals(AutosaveError.Full, workshop.state.document.error)
        workshop.handle(DocumentEvent.NewRequested)
        assertEquals(DocumentDialog.WouldBeLost, workshop.state.document.dialog)
        assertEquals("forward 2", workshop.state.programText)
        workshop.handle(DocumentEvent.DialogClosed)
        machine.store.full = false
        workshop.keep()
        assertNull(workshop.state.document.error)
    }

    @Test
    fun `a project that takes the place of nothing after all can be opened in another window`() {
        val workshop = machine.window()
        workshop.write("forward 1")
        workshop.handle(DocumentEvent.NewRequested)
        workshop.write("forward 2")
        val other = machine.projects(workshop).single { !it.isOpen }.entry.id
        machine.store.full = true
        workshop.write("forward 3")
        workshop.handle(DocumentEvent.SavedProjectChosen(other))
        assertEquals(DocumentDialog.WouldBeLost, workshop.state.document.dialog)
        workshop.handle(DocumentEvent.DialogClosed)
        assertEquals("forward 3", workshop.state.programText)
        machine.store.full = false
        val second = machine.window()
        second.handle(DocumentEvent.SavedProjectChosen(other))
        assertEquals("forward 1", second.state.programText)
    }

    @Test
    fun `a work that cannot be kept can be left nevertheless, or saved first`() {
        val workshop = machine.window()
        machine.store.full = true
        workshop.write("forward 2")
        workshop.handle(DocumentEvent.NewRequested)
        machine.files.location = "/stick/mine.robotran"
        workshop.handle(DocumentEvent.Answered(DocumentAnswer.SAVE_AS))
        assertContains(machine.files.disk.getValue("/stick/mine.robotran").decodeToString(), "forward 2")
        assertContains(workshop.state.programText, "forward 20")
        workshop.write("forward 3")
        workshop.handle(DocumentEvent.NewRequested)
        workshop.handle(DocumentEvent.Answered(DocumentAnswer.GO_ON))
        assertContains(workshop.state.programText, "forward 20")
    }

    @Test
    fun `closing a window whose work cannot be kept asks first`() {
        val workshop = machine.window()
        machine.store.full = true
        workshop.write("forward 2")
        runBlocking {
            val kept = async { workshop.closeDocument() }
            yield()
            assertIs<DocumentDialog.WouldBeLost>(workshop.state.document.dialog)
            workshop.handle(DocumentEvent.DialogClosed)
            assertFalse(kept.await())
            val closed = async { workshop.closeDocument() }
            yield()
            workshop.handle(DocumentEvent.Answered(DocumentAnswer.GO_ON))
            assertTrue(closed.await())
        }
    }

    @Test
    fun `a full place for a file is told`() {
        machine.files.location = "/stick/mine.robotran"
        machine.files.full = true
        val workshop = machine.window()
        workshop.handle(DocumentEvent.SaveAsRequested)
        assertTrue(assertIs<Notice.FileNotSaved>(workshop.state.notice).isFull)
    }

    @Test
    fun `a file that cannot be used is refused and what is on the screen stays`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(DocumentEvent.FilesBrought(listOf(OpenedFile("x.world.json", "{\n\n}".encodeToByteArray()))))
        val error = assertIs<DocumentDialog.Rejected>(workshop.state.document.dialog).error
        assertEquals("x.world.json", assertIs<OpenFilesError.InFile>(error).file)
        assertEquals("forward 7", workshop.state.programText)
    }

    @Test
    fun `a link leads back to the work`() {
        val workshop = machine.window()
        workshop.write("forward 7")
        workshop.handle(DocumentEvent.LinkRequested)
        workshop.handle(DocumentEvent.LinkCopied)
        assertTrue(assertIs<DocumentDialog.SharingLink>(workshop.state.document.dialog).copied)
        val link = assertNotNull(machine.clipboard.text)
        assertIs<LinkResult.OfProject>(runBlocking { openLink(link, Language.ENGLISH) })
        val other = machine.window(OpenRequest.OfLink("https://school.example/$link"))
        assertEquals("forward 7", other.state.programText)
    }

    @Test
    fun `the program in front is in front again after a reload and for whoever gets the link`() {
        val first = machine.window()
        first.write("forward 1")
        first.handle(ProgramEvent.NewProgramRequested(ProgramLanguage.NQC))
        val inFront = first.state.programText
        first.handle(DocumentEvent.LinkRequested)
        first.handle(DocumentEvent.LinkCopied)
        val link = assertNotNull(machine.clipboard.text)
        runBlocking { assertTrue(first.closeDocument()) }
        val second = machine.window()
        assertEquals(inFront, second.state.programText)
        second.handle(ProgramEvent.ProgramChosen(0))
        runBlocking { assertTrue(second.closeDocument()) }
        assertEquals("forward 1", machine.window().state.programText)
        val other = machine.window(OpenRequest.OfLink("https://school.example/$link"))
        assertEquals(inFront, other.state.programText)
    }

    @Test
    fun `a broken link says why and leaves the dialog open`() {
        val workshop = machine.window()
        workshop.handle(DocumentEvent.LinkPastingRequested)
        workshop.handle(DocumentEvent.LinkOpened("#p=a!!!"))
        assertNotNull(assertIs<DocumentDialog.PastingLink>(workshop.state.document.dialog).error)
    }

    @Test
    fun `a replay holds what was done to the run`() {
        val workshop = machine.window()
        workshop.handle(RunEvent.RunPressed)
        workshop.advance(500)
        machine.files.location = "replay.robotran"
        workshop.handle(DocumentEvent.ReplayRequested)
        val project = assertIs<ProjectFileResult.Success>(
            readProject(machine.files.disk.getValue("replay.robotran"), Language.ENGLISH),
        ).project
        assertTrue(project.inputs.isNotEmpty())
    }

    @Test
    fun `the program goes out as its own file and as a kit`() {
        val workshop = machine.window()
        machine.files.location = "program"
        workshop.handle(DocumentEvent.ProgramFileRequested)
        assertEquals("square.robo", machine.files.suggestion)
        assertEquals(workshop.state.programText, machine.files.disk.getValue("program").decodeToString())
        workshop.handle(DocumentEvent.KitRequested)
        assertEquals("square.zip", machine.files.suggestion)
        val zip = ZipInputStream(ByteArrayInputStream(machine.files.disk.getValue("program")))
        assertContains(generateSequence { zip.nextEntry?.name }.toList(), "Square/Square.java")
    }

    private fun Machine.projects(workshop: Workshop) = workshop.run {
        handle(DocumentEvent.ProjectListRequested)
        val projects = assertNotNull(assertIs<DocumentDialog.ProjectList>(state.document.dialog).projects)
        projects
    }

    private val Workshop.listNotice: Notice?
        get() = assertIs<DocumentDialog.ProjectList>(state.document.dialog).notice
}
