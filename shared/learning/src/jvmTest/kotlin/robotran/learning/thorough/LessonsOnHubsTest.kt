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
        for (brick in BrickKind.entries.filter { it.java == null }) {
            val solved = Lessons.allOn(brick).filter { isSolved(it) }.map { it.name }
            assertEquals(solved.joinToString(), lessonsOf(brick).joinToString { it.name }, brick.label)
        }
    }

    /** Whether the solution reaches the goals with three seeds; one that the hub cannot read does not. */
    private suspend fun isSolved(lesson: Lesson): Boolean = (1..3).all { seed ->
        try {
            runInAllPlaces(lesson, lesson.solution.text, seed).isSolved
        } catch (_: AssertionError) {
            false
        }
    }
}
