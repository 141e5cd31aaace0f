package robotran.workshop.handins

import kotlinx.coroutines.ExperimentalCoroutinesApi
import kotlinx.coroutines.test.advanceUntilIdle
import robotran.workshop.Workshop
import robotran.workshop.assignment.AnyCourse
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.CoursePage
import robotran.workshop.state.HandInOrder
import robotran.workshop.state.HandInVerdict
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull

/** Tests how a teacher looks at the hand-ins for all assignments of a course. */
@OptIn(ExperimentalCoroutinesApi::class)
internal class CourseHandInsTest : HandInsTesting() {
    private val tasks = AnyCourse.teachers.assignments

    private fun Workshop.openCourse() {
        handle(DocumentEvent.FilesBrought(listOf(AnyCourse.file(AnyCourse.teachers))))
        time.advanceUntilIdle()
        val key = assertIs<CoursePage.OneCourse>(state.course.page).key
        handle(CourseEvent.HandInsRequested(key))
        time.advanceUntilIdle()
        handle(HandInsEvent.OrderChosen(HandInOrder.NAME))
    }

    private fun Workshop.described() =
        page.rows.map { row -> Triple(row.name, page.tasks.getOrNull(row.task)?.title, row.verdict) }

    @Test
    fun `each hand-in is graded for its assignment, in one table`() = looking(assignment = null) { workshop ->
        workshop.openCourse()
        assertEquals("Circles", workshop.page.title)
        workshop.bring(
            listOf(
                AnyClass.file(AnyClass.handIn("Ada", AnyClass.solved, of = tasks[0]), "a1"),
                AnyClass.file(AnyClass.handIn("Ada", AnyClass.short, of = tasks[1]), "a2"),
                AnyClass.text("Ben - Around the circle.robo", "pen down\nforward 20\n"),
                AnyClass.text("Cleo.robo", "pen down\nforward 20\n"),
            ),
        )
        val expected = listOf(
            Triple("Ada", "Into the circle", HandInVerdict.PASSED),
            Triple("Ada", "Out of the circle", HandInVerdict.MISSED),
            Triple("Ben - Around the circle", "Around the circle", HandInVerdict.PASSED),
            Triple("Cleo", null, HandInVerdict.UNUSABLE),
        )
        assertEquals(expected, workshop.described())
        val csv = workshop.save(HandInsEvent.CsvRequested, "/home/circles.csv").decodeToString().split("\r\n")
        assertEquals(
            listOf("\uFEFFname,assignment,verdict", "Ada,Into the circle,solved", "Ada,Out of the circle,not solved"),
            csv.take(3).map { it.split(',').take(3).joinToString(",") },
        )
        workshop.handle(HandInsEvent.Closed)
        assertNull(workshop.state.handIns)
        assertIs<CoursePage.OneCourse>(workshop.state.course.page)
    }

    @Test
    fun `a later hand-in takes the place of one for the same assignment only, and a removed one comes back`() =
        looking(assignment = null) { workshop ->
            workshop.openCourse()
            listOf(
                AnyClass.handIn("Ada", AnyClass.short, tries = 1, of = tasks[1]),
                AnyClass.handIn("Ada", AnyClass.solved, tries = 2, of = tasks[0]),
                AnyClass.handIn("Ada", AnyClass.solved, tries = 2, of = tasks[1]),
            ).forEach { workshop.bring(listOf(AnyClass.file(it, "a"))) }
            val both = listOf(HandInVerdict.PASSED, HandInVerdict.PASSED)
            assertEquals(both, workshop.page.rows.map { it.verdict })
            workshop.handle(HandInsEvent.HandInRemoved(workshop.page.rows.last().id))
            advanceUntilIdle()
            assertEquals(1, workshop.page.rows.size)
            workshop.handle(HandInsEvent.RemovalUndone)
            advanceUntilIdle()
            assertEquals(both, workshop.page.rows.map { it.verdict })
        }
}
