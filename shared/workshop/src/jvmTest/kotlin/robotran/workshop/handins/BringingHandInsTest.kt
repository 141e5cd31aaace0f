package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.advanceUntilIdle
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.SubmissionRemark
import robotran.documents.ZipEntry
import robotran.documents.zipOf
import robotran.language.Language
import robotran.projects.Project
import robotran.workshop.assignment.AnyAssignment
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.platform.OpenRequest
import robotran.workshop.platform.OpenedFile
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.Settings
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests how hand-ins come to the page: from files, folders and links. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class BringingHandInsTest : HandInsTesting() {
    @Test
    fun `hand-ins come from zips, folders and links, and what is there already is told`() = looking { workshop ->
        val zip = zipOf(AnyClass.few.take(2).map { ZipEntry("class/${it.name}", it.bytes) })
        workshop.bring(listOf(OpenedFile("class.zip", zip)))
        assertEquals(listOf("Ada", "Ben"), workshop.names)
        workshop.bring(AnyClass.few.take(3))
        assertEquals(HandInsMessage.Brought(1, 2), workshop.page.message)
        workshop.handle(HandInsEvent.PastingRequested)
        assertEquals(HandInsDialog.PastingLinks, workshop.page.dialog)
        val links = listOf("Gabi", "Hans").map { link(AnyClass.handIn(it, AnyClass.solved)) }
        workshop.handle(HandInsEvent.LinksPasted("Here it is: ${links[0]}\nand mine ${links[1]} bye"))
        advanceUntilIdle()
        assertNull(workshop.page.dialog)
        assertEquals(listOf("Ada", "Ben", "Cleo", "Gabi", "Hans"), workshop.names)
        workshop.bring(
            listOf(
                OpenedFile("a.robo", "forward 1".encodeToByteArray(), path = "Class 7/Ina/a.robo"),
                OpenedFile("a.robo", "forward 2".encodeToByteArray(), path = "Class 7/Jo/a.robo"),
            ),
        )
        assertEquals(listOf("Ina", "Jo"), workshop.names.filter { it in setOf("Ina", "Jo") })
        assertEquals(7, workshop.page.rows.count { it.graded != null })
    }

    @Test
    fun `what is dropped while the page is open comes to the page, and otherwise to the workshop`() =
        looking { workshop ->
            arrivals.bring(OpenRequest.OfFiles(AnyClass.few.take(1)))
            advanceUntilIdle()
            assertEquals(listOf("Ada"), workshop.names)
            workshop.handle(HandInsEvent.Closed)
            arrivals.bring(
                OpenRequest.OfFiles(listOf(AnyAssignment.file(Project(AnyAssignment.world.copy(title = "Other"))))),
            )
            advanceUntilIdle()
            assertNull(workshop.state.handIns)
            assertEquals("Other", workshop.state.world.title)
        }

    @Test
    fun `a pupil's folder with nothing to read is a row, and in the workshop it is nothing`() = looking { workshop ->
        val folders = listOf(
            OpenedFile("Ben", ByteArray(0), path = "Class 7/Ben/", isUnread = true),
            OpenedFile("holiday.jpg", ByteArray(0), path = "Class 7/Dora/holiday.jpg", isUnread = true),
        )
        val work = OpenedFile("a.robo", "forward 1".encodeToByteArray(), path = "Class 7/Ina/a.robo")
        arrivals.bring(OpenRequest.OfFiles(folders + work))
        advanceUntilIdle()
        assertEquals(listOf("Ben", "Dora", "Ina"), workshop.names)
        assertEquals(
            listOf("The folder is empty.", "There is no program, no project and no link in it."),
            workshop.page.rows.mapNotNull { (it.submission as? Submission.Unusable)?.reason },
        )
        workshop.handle(HandInsEvent.Closed)
        val title = workshop.state.world.title
        arrivals.bring(OpenRequest.OfFiles(folders))
        advanceUntilIdle()
        assertEquals(title, workshop.state.world.title)
        assertNull(workshop.state.document.dialog)
    }

    @Test
    fun `what a pupil hands in again takes the place of the first, and the comment stays`() = looking { workshop ->
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.short, tries = 1)))
        workshop.handle(HandInsEvent.CommentChanged("Ada", "Try again."))
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved, tries = 4)))
        val ada = workshop.page.rows.single()
        assertEquals(HandInVerdict.PASSED, ada.verdict)
        assertEquals("Try again.", ada.comment)
        assertContains(ada.submission.remarks, SubmissionRemark.FewerTries(listOf("Ada.robotran")))
    }

    @Test
    fun `more than there is room for is left out, and that is told`() = looking { workshop ->
        workshop.bring(List(1_001) { AnyClass.text("$it.robo", "forward $it") })
        assertIs<HandInsMessage.TooMany>(workshop.page.message)
        assertEquals(emptyList(), workshop.page.rows)
    }

    @Test
    fun `nothing in what was brought is told`() = looking { workshop ->
        workshop.bring(listOf(OpenedFile("empty.zip", zipOf(emptyList()))))
        assertEquals(HandInsMessage.NothingFound(), workshop.page.message)
        assertEquals(emptyList(), workshop.page.rows)
    }

    @Test
    fun `two pupils of one name are two rows, and the same file twice is one`() = looking { workshop ->
        val first = AnyClass.file(AnyClass.handIn("Ida", AnyClass.solved, tries = 2), "one")
        val second = AnyClass.file(AnyClass.handIn("Ida", AnyClass.short, tries = 5), "two")
        workshop.bring(listOf(first))
        workshop.bring(listOf(second))
        workshop.bring(listOf(OpenedFile("one again.robotran", first.bytes)))
        assertEquals(HandInsMessage.Brought(0, 1), workshop.page.message)
        val rows = workshop.page.rows.sortedBy { it.id }
        assertEquals(listOf("Ida" to true, "Ida" to true), rows.map { it.name to it.hasNamesake })
        assertEquals(listOf("one.robotran", "two.robotran"), rows.map { it.submission.origin })
        // From the same source a later one takes the place of the first.
        val later = AnyClass.file(AnyClass.handIn("Ida", AnyClass.lucky, tries = 3), "one")
        workshop.bring(listOf(later))
        workshop.bring(listOf(first))
        val now = workshop.page.rows.first { it.id == "Ida" }.submission as Submission.Usable
        assertEquals(listOf(2, 3), listOf(workshop.page.rows.size, now.handIn?.tries))
        assertEquals(listOf(SubmissionRemark.FewerTries(listOf("one.robotran"))), now.remarks)
    }

    @Test
    fun `what is no hand-in is named, and gets no row`() = looking { workshop ->
        val teachers = AnyClass.file(AnyClass.teachers, "The assignment")
        workshop.bring(listOf(teachers))
        val note = "The assignment.robotran is the assignment itself, not a hand-in."
        assertEquals(HandInsMessage.NothingFound(listOf(note)), workshop.page.message)
        workshop.bring(listOf(AnyClass.file("Ada", AnyClass.solved), teachers))
        assertEquals(HandInsMessage.Brought(1, 0, listOf(note)), workshop.page.message)
        assertEquals(listOf("Ada"), workshop.page.rows.map { it.name })
        workshop.handle(HandInsEvent.LinksPasted(link(AnyClass.teachers)))
        advanceUntilIdle()
        val ofLink = "Pasted link 1 is the assignment itself, not a hand-in."
        assertEquals(HandInsMessage.NothingFound(listOf(ofLink)), workshop.page.message)
    }

    @Test
    fun `links have numbers and say so in the chosen language`() {
        val links = mutableListOf<String>()
        looking { workshop ->
            listOf("Gabi", "Hans", "Ina").mapTo(links) { link(AnyClass.handIn(it, AnyClass.solved)) }
            workshop.handle(HandInsEvent.LinksPasted("${links[0]} and ${links[1]}"))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.LinksPasted("nothing at all"))
            advanceUntilIdle()
            assertEquals(HandInsMessage.NothingFound(), workshop.page.message)
        }
        looking { workshop ->
            workshop.handle(SettingsEvent.SettingsChanged(Settings(language = Language.GERMAN)))
            workshop.handle(HandInsEvent.Closed)
            workshop.handle(HandInsEvent.Requested)
            advanceUntilIdle()
            workshop.handle(HandInsEvent.LinksPasted(links[2]))
            advanceUntilIdle()
            assertEquals(
                listOf("Eingefügter Link 1", "Eingefügter Link 2", "Eingefügter Link 3"),
                workshop.page.rows.map { it.submission.origin }.sorted(),
            )
            assertTrue(workshop.page.rows.none { it.graded == null })
        }
    }
}
