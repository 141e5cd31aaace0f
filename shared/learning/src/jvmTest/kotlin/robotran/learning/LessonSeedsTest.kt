package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import robotran.language.Language
import kotlin.test.Test
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class LessonSeedsTest {
    @Test
    fun `every solution reaches the goals with 20 seeds`() = runTest(timeout = 5.minutes) { reachGoals(BrickKind.RCX) }

    @Test
    fun `every solution for an NXT does, too`() = runTest(timeout = 5.minutes) { reachGoals(BrickKind.NXT) }

    private suspend fun reachGoals(brick: BrickKind) {
        val failed = mutableListOf<String>()
        for (lesson in Lessons.all.map { it.on(brick) }) {
            // Without deviations of the robot, a seed changes nothing.
            if (lesson.world(Language.ENGLISH).realism == 0.0) continue
            for (seed in 2..SEEDS) {
                val solved = runIn(lesson, lesson.solution.text, seed)
                if (!solved.isSolved) {
                    failed +=
                        "${lesson.name}, seed $seed: ${solved.run.goals}, ${solved.run.robot.pose}"
                }
            }
        }
        assertTrue(failed.isEmpty(), failed.joinToString("\n"))
    }

    private companion object {
        const val SEEDS = 20
    }
}
