package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.advanceUntilIdle
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.finish
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.physics.loadPhysicsEngine
import robotran.workshop.event.HandInsEvent
import robotran.workshop.platform.GradingCrew
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.state.HandInVerdict
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsMessage
import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests what the device keeps of hand-ins, and how they are removed. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class KeptHandInsTest : HandInsTesting() {
    @Test
    fun `hand-ins and comments are there again when the app has been closed`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
            workshop.saveDocumentNow()
        }
        looking { workshop ->
            assertEquals(listOf("Ada", "Ben", "Cleo", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals("A little further.", workshop.row("Ben").comment)
            assertTrue(workshop.page.rows.none { it.graded == null })
        }
        val other = AnyClass.teachers.copy(assignment = AnyClass.teachers.assignment?.copy(id = "another"))
        looking(other) { assertEquals(emptyList(), it.page.rows) }
    }

    /** Counts the hand-ins that it grades. */
    private class CountingWorkers : GradingWorkers {
        var count = 0

        override suspend fun start(assignment: Project, plan: GradingPlan, language: Language): GradingCrew {
            val grader = HandInGrader(assignment, plan, loadPhysicsEngine(), language)
            return object : GradingCrew {
                override val size = 1

                override suspend fun grade(
                    submission: Submission.Usable,
                    onProgress: (runs: Int) -> Unit,
                ): GradedHandIn {
                    count++
                    return grader.prepare(submission).finish(onProgress)
                }

                override fun close() = Unit
            }
        }
    }

    @Test
    fun `results are kept, and one hand-in is graded again to see whether they still hold`() {
        val counting = CountingWorkers()
        workers = counting
        var csv = byteArrayOf()
        looking { workshop ->
            workshop.bring(AnyClass.few)
            csv = workshop.save(HandInsEvent.CsvRequested, "/home/one.csv")
            workshop.saveDocumentNow()
        }
        assertEquals(5, counting.count)
        looking { workshop ->
            assertTrue(workshop.page.rows.none { it.graded == null })
            assertContentEquals(csv, workshop.save(HandInsEvent.CsvRequested, "/home/two.csv"))
        }
        assertEquals(6, counting.count)
        val stricter = AnyClass.teachers.run {
            copy(assignment = assignment?.copy(checks = assignment?.checks?.copy(seeds = 1..3)))
        }
        looking(stricter) { assertTrue(it.page.rows.none { row -> row.graded == null }) }
        assertEquals(11, counting.count)
    }

    @Test
    fun `removing asks, and then leaves nothing on the device`() = looking { workshop ->
        workshop.bring(AnyClass.few)
        workshop.handle(HandInsEvent.CommentChanged("Ben", "A little further."))
        workshop.handle(HandInsEvent.RemovalRequested)
        assertEquals(HandInsDialog.Removing(6), workshop.page.dialog)
        workshop.handle(HandInsEvent.DialogClosed)
        assertEquals(6, workshop.page.rows.size)
        workshop.handle(HandInsEvent.RemovalConfirmed)
        advanceUntilIdle()
        assertEquals(emptyList(), workshop.page.rows)
        assertEquals(emptyList(), store.names().filter { it.startsWith("hand-ins") })
        workshop.bring(AnyClass.few.take(1))
        assertEquals(listOf("" to HandInVerdict.PASSED), workshop.page.rows.map { it.comment to it.verdict })
    }

    @Test
    fun `a full device is told, and the hand-ins are open all the same`() = looking { workshop ->
        store.full = true
        workshop.bring(AnyClass.few.take(1))
        assertEquals(HandInsMessage.NotKept(""), workshop.page.message)
        assertEquals(HandInVerdict.PASSED, workshop.row("Ada").verdict)
    }

    @Test
    fun `a removed hand-in is gone for good, and the others stay graded`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Cleo", "Luck."))
            workshop.handle(HandInsEvent.CommentChanged("Ben", "Further."))
            val graded = workshop.page.rows.associate { it.id to it.graded }
            workshop.handle(HandInsEvent.HandInChosen("Cleo"))
            workshop.handle(HandInsEvent.HandInRemoved("Cleo"))
            assertNull(workshop.page.progress)
            advanceUntilIdle()
            assertNull(workshop.page.opened)
            assertEquals(listOf("Ada", "Ben", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals(HandInsMessage.Removed("Cleo"), workshop.page.message)
            assertTrue(workshop.page.rows.all { it.graded === graded[it.id] })
            val csv = workshop.save(HandInsEvent.CsvRequested, "/home/class.csv").decodeToString()
            assertFalse("Cleo" in csv)
            workshop.saveDocumentNow()
        }
        looking { workshop ->
            assertEquals(listOf("Ada", "Ben", "Dina", "Emil", "Fritz"), workshop.names)
            assertEquals("Further.", workshop.row("Ben").comment)
            workshop.bring(AnyClass.few.take(3))
            assertEquals(HandInsMessage.Brought(1, 2), workshop.page.message)
            assertEquals("", workshop.row("Cleo").comment)
        }
        looking { workshop -> assertEquals(6, workshop.page.rows.size) }
    }

    @Test
    fun `a removal can be undone`() {
        looking { workshop ->
            workshop.bring(AnyClass.few)
            workshop.handle(HandInsEvent.CommentChanged("Cleo", "Luck."))
            val before = workshop.page.rows
            workshop.handle(HandInsEvent.HandInRemoved("Cleo"))
            advanceUntilIdle()
            workshop.handle(HandInsEvent.RemovalUndone)
            assertNull(workshop.page.progress)
            advanceUntilIdle()
            assertEquals(before.map { it.id to it.comment }, workshop.page.rows.map { it.id to it.comment })
            assertTrue(before.zip(workshop.page.rows).all { (one, other) -> one.graded === other.graded })
            assertNull(workshop.page.message)
            // There is nothing more to undo.
            workshop.handle(HandInsEvent.RemovalUndone)
            assertEquals(6, workshop.page.rows.size)
            workshop.saveDocumentNow()
        }
        looking { workshop -> assertEquals("Luck.", workshop.row("Cleo").comment) }
    }

    @Test
    fun `IDs stay with their hand-ins although one before them was removed`() {
        looking { workshop ->
            workshop.bring(listOf(AnyClass.file(AnyClass.handIn("Ida", AnyClass.solved), "one")))
            workshop.bring(listOf(AnyClass.file(AnyClass.handIn("Ida", AnyClass.short), "two")))
            workshop.handle(HandInsEvent.CommentChanged("Ida 2", "Further."))
            workshop.handle(HandInsEvent.HandInRemoved("Ida"))
            advanceUntilIdle()
            assertFalse(workshop.page.rows.single().hasNamesake)
            workshop.saveDocumentNow()
        }
        looking { workshop -> assertEquals("Further.", workshop.page.rows.single().comment) }
    }
}
