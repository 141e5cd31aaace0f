package robotran.workshop.documents

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.runBlocking
import robotran.projects.Project
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.Services
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.StoppedWork
import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** No saved project keeps anybody from the list of My work, whatever happens while it is opened. */
class HostileProjectsTest {
    private val machine = Machine().also { machine ->
        machine.window().write("// another work")
        machine.clock.now += 1_000
        machine.window().write("// hostile")
    }

    @Test
    fun `a project whose compiler never answers stops only one start`() = stopsOnlyOneStart {
        CountDownLatch(1).await()
    }

    @Test
    fun `a project whose compiler throws stops only one start`() = stopsOnlyOneStart { error("a bug of the compiler") }

    @Test
    fun `a project that eats all memory stops only one start`() = stopsOnlyOneStart { throw OutOfMemoryError() }

    private fun stopsOnlyOneStart(harm: () -> Unit) {
        val first = machine.afterKill()
        val isReached = CountDownLatch(1)
        thread(isDaemon = true) {
            runCatching {
                first.start {
                    isReached.countDown()
                    harm()
                }
            }
        }
        assertTrue(isReached.await(1, TimeUnit.MINUTES), "the project is opened")

        val document = first.afterKill().start(harm)
        val asked = assertIs<DocumentDialog.StoppedLastTime>(document.state.dialog)
        assertEquals("My first work 2", asked.name)
        val id = assertIs<StoppedWork.Stored>(asked.work).id
        document.handle(DocumentEvent.ProjectListRequested)
        val list = assertNotNull(assertIs<DocumentDialog.ProjectList>(document.state.dialog).projects)
        assertEquals(setOf("My first work", "My first work 2"), list.map { it.entry.name }.toSet())
        assertEquals(null, list.first { it.entry.id == id }.project, "no picture is drawn of it")
        assertNotNull(list.first { it.entry.id != id }.project)

        // It is asked about as long as it was not opened to its end, and the other work is opened meanwhile.
        document.handle(DocumentEvent.SavedProjectChosen(id))
        assertIs<DocumentDialog.StoppedLastTime>(document.state.dialog)
        document.handle(DocumentEvent.SavedProjectChosen(list.first { it.entry.id != id }.entry.id))
        assertEquals("My first work", document.state.name)
    }

    /** A window of this machine in which the hostile project does [harm] when it is opened. */
    private fun Machine.start(harm: () -> Unit): DocumentStateHolder {
        // Its own documents are never started: it only shows what the other ones open.
        val workshop = Machine().window()
        val document = documentOf(workshop, HarmedEditor(workshop.services.editor, harm))
        runBlocking { document.start() }
        return document
    }

    private fun Machine.documentOf(workshop: Workshop, editor: ProjectEditor): DocumentStateHolder {
        val services = with(workshop.services) {
            Services(
                platform(),
                CoroutineScope(Dispatchers.Unconfined),
                preferences,
                current,
                editor,
                assignments,
                navigator,
                notices,
                events,
                { tabs },
                { runControls },
            )
        }
        return DocumentStateHolder(services, openCourses = { })
    }

    private class HarmedEditor(private val editor: ProjectEditor, private val harm: () -> Unit) :
        ProjectEditor by editor {
        override fun openProject(project: Project) {
            val programs = project.robots.flatMap { it.programs }
            if (programs.any { program -> program.files.any { "hostile" in it.text } }) harm()
            editor.openProject(project)
        }
    }
}
