package robotran.learning

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class LessonSolutionsTest {
    @Test
    fun `every solution reaches the goals and the program that is given does not`() = runTest(timeout = 5.minutes) {
        for (lesson in Lessons.all) {
            val solved = runInAllPlaces(lesson, lesson.solution.text)
            assertTrue(solved.isSolved, "${lesson.name} is not solved: ${solved.run.goals}, ${solved.run.robot.pose}")
            assertFalse(
                runIn(lesson, lesson.program.text).isSolved,
                "${lesson.name} is solved before anybody has done anything",
            )
        }
    }
}
