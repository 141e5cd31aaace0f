package robotran.workshop.documents

import androidx.compose.runtime.BroadcastFrameClock
import androidx.compose.runtime.snapshots.Snapshot
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.yield
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.StoppedWork
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotEquals
import kotlin.test.assertNull

/** What is opened is marked until it is compiled and drawn, and nothing else is asked about. */
class OpeningMarksTest {
    private val machine = Machine()

    @Test
    fun `what was opened, compiled and drawn has no mark any more, and comes back without a question`() {
        machine.window().write("forward 7")
        val next = machine.afterKill()
        val window = next.window()
        assertNotEquals(emptyMap(), next.marks.times)
        window.draw()
        assertEquals(emptyMap(), next.marks.times)
        assertEquals("forward 7", next.afterKill().window().state.programText)
    }

    @Test
    fun `a window that is closed or hidden while it opens a project was alive, so nothing is asked`() {
        machine.window().write("forward 7")
        for (leave in listOf<suspend (Workshop) -> Unit>({ it.closeDocument() }, { it.hideDocument() })) {
            val next = machine.afterKill()
            runBlocking { leave(next.window()) }
            assertEquals(emptyMap(), next.marks.times)
        }
    }

    @Test
    fun `a run marks its project until it is drawn`() {
        val window = machine.window().also { it.write("forward 7") }
        assertEquals(emptyMap(), machine.marks.times)
        window.handle(RunEvent.RunPressed)
        val asked = machine.afterKill().window()
        assertIs<DocumentDialog.StoppedLastTime>(asked.state.document.dialog)
        assertContains(asked.state.programText, "forward 20")
        window.draw()
        assertEquals("forward 7", machine.afterKill().window().state.programText)
    }

    @Test
    fun `a link that stopped the app asks the next time, and is opened if that is wanted`() {
        val link = OpenRequest.OfLink(linkOf("forward 9"))
        machine.window(link)
        // Its project is saved by then, and it is this that the next start would restore.
        val next = machine.afterKill()
        assertIs<StoppedWork.Stored>(next.window().stopped)
        next.clock.now += 60_000
        val again = next.afterKill().also {
            it.marks.times.keys.removeAll { name ->
                name.startsWith("w")
            }
        }.window(link)
        assertEquals(StoppedWork.OfLink(link.link), again.stopped)
        assertContains(again.state.programText, "forward 20")
        again.handle(DocumentEvent.StoppedWorkOpened)
        assertEquals("forward 9", again.state.programText)
        assertNull(again.state.document.dialog)
    }

    @Test
    fun `a link that another window opens at the same time is no alarm`() {
        val link = OpenRequest.OfLink(linkOf("forward 9"))
        machine.window(link)
        machine.clock.now += 500
        assertEquals("forward 9", machine.window(link).state.programText)
    }

    @Test
    fun `a file that stopped the app asks the next time`() {
        val file = OpenRequest.OfFiles(listOf(projectFile("forward 9")))
        machine.window(file)
        val next = machine.afterKill()
        next.clock.now += 60_000
        val asked = next.window(file)
        assertEquals(StoppedWork.OfFiles, asked.stopped)
        asked.handle(DocumentEvent.StoppedWorkOpened)
        assertEquals("forward 9", asked.state.programText)
    }

    @Test
    fun `what stopped the app is saved as a file without being opened`() {
        machine.window().write("forward 7")
        machine.afterKill().let { next ->
            next.window()
            val last = next.afterKill()
            val asked = last.window()
            last.files.location = "/home/saved.robotran"
            asked.handle(DocumentEvent.StoppedWorkSaved)
            assertContains(last.files.disk.getValue("/home/saved.robotran").decodeToString(), "forward 7")
            assertContains(asked.state.programText, "forward 20")
        }
    }

    @Test
    fun `pictures that stopped the list of projects are left out the next time`() {
        machine.window().also { it.write("forward 7") }.handle(DocumentEvent.ProjectListRequested)
        val next = machine.afterKill().window()
        next.handle(DocumentEvent.ProjectListRequested)
        val list = assertIs<DocumentDialog.ProjectList>(next.state.document.dialog)
        assertEquals(listOf(null), list.projects?.map { it.project })
    }

    private val Workshop.stopped get() = (state.document.dialog as? DocumentDialog.StoppedLastTime)?.work

    private fun linkOf(text: String): String {
        val other = Machine().window(OpenRequest.OfFiles(listOf(projectFile(text))))
        other.handle(DocumentEvent.LinkRequested)
        return checkNotNull((other.state.document.dialog as DocumentDialog.SharingLink).link)
    }

    /** Draws some frames of this window. */
    private fun Workshop.draw() = runBlocking {
        val frames = BroadcastFrameClock()
        val guard = launch(frames) { runOpeningGuard() }
        repeat(10) {
            Snapshot.sendApplyNotifications()
            yield()
            frames.sendFrame(it.toLong())
        }
        guard.cancel()
    }
}
