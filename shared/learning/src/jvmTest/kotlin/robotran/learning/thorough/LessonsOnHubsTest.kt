package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.learning.Lesson
import robotran.learning.Lessons
import robotran.learning.lessonsOf
import robotran.learning.runInAllPlaces
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class LessonsOnHubsTest {
    @Test
    fun `a hub has the lessons that its robot can do as they are, and no others`() = runTest(timeout = 30.minutes) {
        val hubs = BrickKind.entries.filter { it.java == null }
        val solved = hubs.map { brick -> brick to Lessons.allOn(brick).filter { isSolved(it) } }
        assertEquals(solved.map(::line).joinToString("\n"), hubs.map { line(it to lessonsOf(it)) }.joinToString("\n"))
    }

    private fun line(lessons: Pair<BrickKind, List<Lesson>>): String =
        "${lessons.first.label}: ${lessons.second.map { it.name }.sorted().joinToString()}"

    /** Whether the solution reaches the goals with three seeds; one that the hub cannot read does not. */
    private suspend fun isSolved(lesson: Lesson): Boolean = (1..3).all { seed ->
        try {
            runInAllPlaces(lesson, lesson.solution.text, seed).isSolved
        } catch (_: AssertionError) {
            false
        }
    }
}
