package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class LessonSeedsTest {
    @Test
    fun `every solution reaches the goals with 20 seeds`() = runTest(timeout = 5.minutes) {
        for (lesson in Lessons.all) {
            // Without deviations of the robot, a seed changes nothing.
            if (lesson.world(Language.ENGLISH).realism == 0.0) continue
            for (seed in 2..SEEDS) {
                val solved = runIn(lesson, lesson.solution.text, seed)
                assertTrue(solved.isSolved, "${lesson.name}, seed $seed: ${solved.run.goals}, ${solved.run.robot.pose}")
            }
        }
    }

    private companion object {
        const val SEEDS = 20
    }
}
