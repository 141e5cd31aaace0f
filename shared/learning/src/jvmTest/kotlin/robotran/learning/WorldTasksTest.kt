package robotran.learning

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class WorldTasksTest {
    @Test
    fun `every solution reaches the goals with 20 seeds`() = runTest(timeout = 10.minutes) {
        val failed = worldTasks.flatMap { task ->
            (1..SEEDS).filterNot { runIn(task, task.solution.text, it).isSolved }.map { "${task.name}, seed $it" }
        }
        assertEquals(emptyList(), failed)
    }

    @Test
    fun `the program that is given reaches the goals nowhere`() = runTest(timeout = 5.minutes) {
        assertEquals(emptyList(), worldTasks.filter { runIn(it, it.program.text).isSolved }.map { it.name })
    }

    @Test
    fun `the solution of a world does not solve its harder variations`() = runTest(timeout = 5.minutes) {
        val solved = WorldGallery.worlds.flatMap { world ->
            val solution = world.lesson?.solution?.text.orEmpty()
            world.harder.mapNotNull { it.lesson }.filter { runIn(it, solution).isSolved }
        }
        assertEquals(emptyList(), solved.map { it.name })
    }

    private companion object {
        const val SEEDS = 20
    }
}
