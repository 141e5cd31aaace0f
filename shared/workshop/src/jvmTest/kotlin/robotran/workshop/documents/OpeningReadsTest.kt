package robotran.workshop.documents

import kotlinx.coroutines.runBlocking
import robotran.assignments.doing.pupilCopy
import robotran.language.Language
import robotran.projects.LinkCreation
import robotran.projects.Project
import robotran.projects.linkOf
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

/** The way of a link that is opened: each stored project is read at most once. */
class OpeningReadsTest {
    private val machine = Machine()
    private var stored = emptyList<String>()

    /** Stores [count] projects, one of them work at the assignment. */
    private fun store(count: Int) {
        for (number in 1..count) {
            val project = pupilCopy(
                if (number ==
                    1
                ) {
                    AnyAssignment.teachers
                } else {
                    AnyCourse.task(number + 1, "Task $number")
                },
            )
            val window = machine.window(OpenRequest.OfLink(linkTo(project)))
            window.write("forward $number\n")
            window.keep()
            window.close()
        }
        stored = runBlocking { machine.store.names() }.filter { it.startsWith("work-") }
        machine.store.reads.clear()
    }

    private fun linkTo(project: Project): String = runBlocking {
        assertIs<LinkCreation.Made>(linkOf(project, Language.ENGLISH)).fragment
    }

    private fun assertReadOnce() {
        val reads = machine.store.reads.filterKeys { it in stored }
        assertEquals(stored.associateWith { 1 }, reads)
    }

    @Test
    fun `a link that is opened in a window reads each project at most once`() {
        store(4)
        val window = machine.window()
        machine.store.reads.clear()
        window.handle(DocumentEvent.LinkOpened(linkTo(pupilCopy(AnyAssignment.teachers))))
        assertIs<Notice.AssignmentBegunBefore>(window.state.notice)
        assertReadOnce()
    }

    @Test
    fun `so does one with which a window begins`() {
        store(4)
        val window = machine.window(OpenRequest.OfLink(linkTo(pupilCopy(AnyAssignment.teachers))))
        assertIs<Notice.AssignmentBegunBefore>(window.state.notice)
        assertReadOnce()
    }

    @Test
    fun `so does a course`() {
        store(4)
        val window = machine.window()
        machine.store.reads.clear()
        window.handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(AnyCourse.teachers))))
        assertReadOnce()
    }
}
