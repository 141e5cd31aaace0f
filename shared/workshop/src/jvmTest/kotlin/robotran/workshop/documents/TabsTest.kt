package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.state.Notice
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** Several browser tabs and their reloads. */
class TabsTest {
    private val machine = Machine()
    private val memory = TabMemory()

    @Test
    fun `two tabs that are begun have works of different names`() {
        machine.tab(memory).write("forward 1")
        val second = machine.tab(TabMemory())
        assertEquals("My first work 2", second.state.document.name)
        second.write("forward 2")
        assertEquals(listOf("My first work", "My first work 2"), second.projects().map { it.entry.name }.sorted())
    }

    @Test
    fun `tabs that were begun at the same time get different names as soon as both are kept`() {
        val first = machine.tab(memory)
        val second = machine.tab(TabMemory())
        first.write("forward 1")
        second.write("forward 2")
        assertEquals(listOf("My first work", "My first work 2"), listOf(first, second).map { it.state.document.name })
    }

    @Test
    fun `two windows in which nothing was done have different names, and the second says where the work is`() {
        val names = List(3) { machine.tab(TabMemory()).state.document.name }
        assertEquals(listOf("My first work", "My first work 2", "My first work 3"), names)
        val machine = Machine()
        machine.tab(TabMemory()).write("forward 1")
        assertEquals(Notice.LastProjectOpenElsewhere("My first work"), machine.tab(TabMemory()).state.notice)
    }

    @Test
    fun `a work that is renamed as another is gets a number`() {
        val workshop = machine.tab(memory)
        workshop.write("forward 1")
        workshop.handle(DocumentEvent.Renamed("Maze"))
        workshop.keep()
        workshop.handle(DocumentEvent.NewRequested)
        workshop.write("forward 2")
        workshop.handle(DocumentEvent.Renamed("Maze"))
        assertEquals("Maze 2", workshop.state.document.name)
        workshop.handle(DocumentEvent.Renamed("Maze 2"))
        assertEquals("Maze 2", workshop.state.document.name)
    }

    @Test
    fun `a tab comes back with its own work, whatever was closed in between`() {
        val first = machine.tab(memory).also { it.write("forward 1") }
        val second = machine.tab(TabMemory()).also { it.write("forward 2") }
        runBlocking { second.hideDocument() }
        second.close()
        first.close()
        assertEquals("forward 1", machine.tab(memory).state.programText)
    }

    @Test
    fun `a tab in which nothing was done stays empty, and a new one goes on with what was closed`() {
        machine.tab(memory).close()
        machine.tab(TabMemory()).also { it.write("forward 2") }.close()
        assertContains(machine.tab(memory).state.programText, "forward 20")
        assertEquals("forward 2", machine.tab(TabMemory()).state.programText)
    }

    @Test
    fun `a tab that was duplicated says where the work is, and begins a new one`() {
        val first = machine.tab(memory).also { it.write("forward 1") }
        val twin = machine.tab(TabMemory(memory.projectId))
        assertContains(twin.state.programText, "forward 20")
        assertEquals(Notice.OwnProjectOpenElsewhere, twin.state.notice)
        twin.write("forward 2")
        assertEquals("forward 1", first.state.programText)
        assertEquals(2, first.projects().size)
    }

    @Test
    fun `a reload says nothing, a crash does`() {
        machine.tab(memory).also { it.write("forward 1") }.close()
        val reloaded = machine.tab(memory)
        assertNull(reloaded.state.notice)
        reloaded.close()
        machine.marks.times.clear() // It was drawn before.
        memory.hasEnded = false
        assertIs<Notice.ProjectRestored>(machine.tab(memory).state.notice)
    }

    @Test
    fun `what could not be kept before the page went is there again, and is kept then`() {
        val first = machine.tab(memory).also { it.write("forward 1") }
        machine.store.full = true
        machine.clock.now += 1_000
        first.handle(ProgramEvent.ProgramEdited("forward 12"))
        runBlocking { first.hideDocument() }
        first.close()
        machine.store.full = false
        machine.clock.now += 1_000
        val second = machine.tab(memory)
        assertEquals("forward 12", second.state.programText)
        assertNull(memory.projectId?.let(memory::left))
        second.write("forward 13")
        runBlocking { second.hideDocument() }
        second.close()
        assertEquals("forward 13", machine.tab(memory).state.programText)
    }

    @Test
    fun `the first letters of a tab that is gone before any was kept come back, in the next tab or after a reload`() {
        for (isReload in listOf(false, true)) {
            val machine = Machine()
            val left = mutableMapOf<String, String>()
            val memory = TabMemory(texts = left)
            machine.tab(memory).also { machine.goAfter(it, "forward 7") }
            val next = machine.tab(if (isReload) memory else TabMemory(texts = left))
            assertEquals("forward 7", next.state.programText)
            assertNull(next.state.notice)
            next.keep()
            assertEquals(emptyMap(), left)
            assertEquals(1, next.projects().size)
        }
    }

    @Test
    fun `two tabs that are gone before they could keep their last letters lose none of them`() {
        val left = mutableMapOf<String, String>()
        val tabs = listOf("forward 1", "forward 2").map { text ->
            machine.tab(TabMemory(texts = left)).also { it.write(text) }
        }
        tabs.forEachIndexed { number, tab -> machine.goAfter(tab, "forward 1$number") }
        val next = machine.tab(TabMemory(texts = left))
        assertEquals(emptyMap(), left)
        val texts = next.projects().map { work ->
            next.handle(DocumentEvent.SavedProjectChosen(work.entry.id))
            next.state.programText
        }
        assertEquals(setOf("forward 10", "forward 11"), texts.toSet())
    }

    @Test
    fun `a tab that was only out of sight leaves nothing behind once it has kept all`() {
        val left = mutableMapOf<String, String>()
        val tab = machine.tab(TabMemory(texts = left))
        tab.handle(ProgramEvent.ProgramEdited("forward 7"))
        runBlocking { tab.hideDocument() }
        assertEquals(emptyMap(), left)
        assertEquals(1, tab.projects().size)
    }

    /** Types [text] into [tab], which then closes before it can autosave. */
    private fun Machine.goAfter(tab: Workshop, text: String) {
        clock.now += 1_000
        store.full = true
        tab.handle(ProgramEvent.ProgramEdited(text))
        runBlocking { tab.hideDocument() }
        tab.close()
        store.full = false
        clock.now += 1_000
    }

    @Test
    fun `a link that comes into a tab leaves the way back to its work`() {
        machine.tab(memory).also { it.write("forward 1") }.close()
        val other = machine.tab(memory, OpenRequest.OfFiles(listOf(projectFile("beep"))))
        assertEquals("beep", other.state.programText)
        other.handle(WorkshopEvent.NoticeTaken)
        assertEquals("forward 1", other.state.programText)
    }
}
