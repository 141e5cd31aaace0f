package robotran.learning

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertFalse
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

class WorldTasksTest {
    @Test
    fun `every solution reaches the goals with 20 seeds`() = runTest(timeout = 10.minutes) {
        for (task in worldTasks) {
            for (seed in 1..SEEDS) {
                val solved = runIn(task, task.solution.text, seed)
                assertTrue(solved.isSolved, "${task.name}, seed $seed: ${solved.run.goals}, ${solved.run.robot.pose}")
            }
        }
    }

    @Test
    fun `the program that is given reaches the goals nowhere`() = runTest(timeout = 5.minutes) {
        for (task in worldTasks) assertFalse(runIn(task, task.program.text).isSolved, task.name)
    }

    @Test
    fun `the solution of a world does not solve its harder variations`() = runTest(timeout = 5.minutes) {
        for (world in WorldGallery.worlds) {
            val solution = world.lesson?.solution?.text ?: continue
            for (harder in world.harder.mapNotNull { it.lesson }) {
                assertFalse(runIn(harder, solution).isSolved, harder.name)
            }
        }
    }

    private companion object {
        const val SEEDS = 20
    }
}
