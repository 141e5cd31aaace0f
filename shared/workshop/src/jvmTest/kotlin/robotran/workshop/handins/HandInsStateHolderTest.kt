package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.advanceUntilIdle
import robotran.language.Language
import robotran.projects.ProjectFileResult
import robotran.projects.readProject
import robotran.workshop.Workshop
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.ProgramEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInRun
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.Notice
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests what a teacher does with hand-ins on the page: orders, compares, replays and saves them. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class HandInsStateHolderTest : HandInsTesting() {
    @Test
    fun `equal programs are marked, and stand side by side`() = looking { workshop ->
        val own = AnyClass.robolang(
            "pen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\nshow 7\n",
        )
        val copy = AnyClass.robolang(
            "// mine\npen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\nshow 7\n",
        )
        workshop.bring(
            listOf(AnyClass.file("Ada", own), AnyClass.file("Ben", copy), AnyClass.file("Cleo", AnyClass.short)),
        )
        assertEquals(listOf("Ben"), workshop.row("Ada").alike.map { it.name })
        assertEquals(listOf("Ada"), workshop.row("Ben").alike.map { it.name })
        assertEquals(emptyList(), workshop.row("Cleo").alike)
        workshop.handle(HandInsEvent.HandInChosen("Ada"))
        workshop.handle(HandInsEvent.ComparisonChosen("Ben"))
        assertEquals("Ben", workshop.page.opened?.beside)
        assertEquals(1, workshop.page.tasks.single().solution.size)
    }

    @Test
    fun `the table is ordered by name, or by who needs help first`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        assertEquals(listOf("Fritz", "Dina", "Ben", "Emil", "Cleo", "Ada"), workshop.page.rows.map { it.name })
        workshop.handle(HandInsEvent.OrderChosen(HandInOrder.NAME))
        assertEquals(listOf("Ada", "Ben", "Cleo", "Dina", "Emil", "Fritz"), workshop.page.rows.map { it.name })
    }

    @Test
    fun `a replay is the failed run in the workshop, and leads back to the hand-ins`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        val failed = checkNotNull(workshop.row("Cleo").results).runs.first { !it.grade.passed }
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        val run = HandInRun(failed.world.name, failed.grade.seed)
        workshop.handle(HandInsEvent.ReplayRequested("Cleo", run))
        advanceUntilIdle()
        assertNull(workshop.state.handIns)
        assertEquals(Notice.HandInOpened("Cleo", run), workshop.state.notice)
        assertEquals(AnyClass.lucky.files.single().text, workshop.state.programText)
        workshop.advance(20_000)
        assertEquals(failed.grade.goals.map { it.status }, workshop.state.session.goals.map { it.status })
        workshop.handle(WorkshopEvent.NoticeDismissed)
        assertEquals(Notice.HandInOpen, workshop.state.notice)
        workshop.handle(WorkshopEvent.NoticeTaken)
        advanceUntilIdle()
        assertNull(workshop.state.notice)
        assertEquals("Cleo", workshop.page.opened?.id)
        assertEquals(AnyClass.teachers.assignment, workshop.project.assignment)
        assertEquals(listOf("Circle"), workshop.projectNames())
    }

    @Test
    fun `the menu leads back from a replay, too, and what was changed in it stays in My work`() = looking { workshop ->
        workshop.bring(AnyClass.few.take(1))
        workshop.handle(HandInsEvent.ReplayRequested("Ada", null))
        advanceUntilIdle()
        assertTrue(workshop.state.run.running || workshop.state.run.time > 0 || workshop.state.awake)
        workshop.handle(ProgramEvent.ProgramEdited("forward 3"))
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals(listOf("Ada"), workshop.names)
        assertEquals(setOf("Circle", "Ada"), workshop.projectNames().toSet())
    }

    @Test
    fun `results are saved as a table, a page, and feedback files`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
        workshop.save(HandInsEvent.CsvRequested, "/home/class.csv").decodeToString().let { csv ->
            assertEquals(7, csv.trim().lines().size)
            assertContains(csv, "Ben,")
        }
        val page = workshop.save(HandInsEvent.PageRequested, "/home/class.html").decodeToString()
        assertContains(page, "A little further.")
        assertEquals(HandInsMessage.Saved("class.html"), workshop.page.message)
        val zip = workshop.save(HandInsEvent.FeedbackRequested, "/home/class.zip")
        assertContains(zip.decodeToString(), "Ben - feedback - ")
        val file = workshop.save(HandInsEvent.FeedbackFileRequested("Ben"), "/home/Ben.robotran").decodeToString()
        val project = assertIs<ProjectFileResult.Success>(readProject(file, Language.ENGLISH)).project
        assertEquals("A little further.", project.feedback?.comment)
        files.full = true
        workshop.handle(HandInsEvent.CsvRequested)
        advanceUntilIdle()
        assertEquals(HandInsMessage.NotSaved("", isFull = true), workshop.page.message)
    }

    @Test
    fun `time stands still behind the page`() = looking { workshop ->
        repeat(20) { workshop.frame(it * 16_000_000L) }
        assertEquals(0, workshop.state.run.time)
    }

    @Test
    fun `any two hand-ins can be compared, the most similar first`() = looking { workshop ->
        val own = AnyClass.robolang("pen down\nrepeat 4 times\n  forward 5\n  turn left 90\nend\nforward 20\nbeep\n")
        workshop.bring(
            listOf(
                AnyClass.file("Ada", AnyClass.short),
                AnyClass.file("Ben", own),
                AnyClass.file("Cleo", AnyClass.java("class Circle { }")),
                AnyClass.file("Zoe", own),
                AnyClass.text("Fritz.robotran", "{ \"format\": \"robotran-project\""),
            ),
        )
        workshop.handle(HandInsEvent.HandInChosen("Ben"))
        assertEquals(listOf("Zoe", "Ada", "Cleo"), workshop.page.comparable.map { it.name })
        workshop.handle(HandInsEvent.ComparisonsRequested)
        assertEquals(HandInsDialog.Comparing, workshop.page.dialog)
        workshop.handle(HandInsEvent.ComparisonChosen("Ada"))
        assertEquals(null to "Ada", workshop.page.dialog to workshop.page.opened?.beside)
    }

    @Test
    fun `the page knows which hand-in was open last, also after a replay`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.HandInChosen("Cleo"))
        workshop.handle(HandInsEvent.HandInChosen(null))
        assertEquals("Cleo", workshop.page.last)
        workshop.handle(HandInsEvent.ReplayRequested("Ben", null))
        advanceUntilIdle()
        workshop.handle(HandInsEvent.Requested)
        advanceUntilIdle()
        assertEquals("Ben", workshop.page.last)
    }

    private fun Workshop.projectNames(): List<String> {
        handle(DocumentEvent.ProjectListRequested)
        time.advanceUntilIdle()
        val list = state.document.dialog as DocumentDialog.ProjectList
        return list.projects.orEmpty().map { it.entry.name }
    }
}
