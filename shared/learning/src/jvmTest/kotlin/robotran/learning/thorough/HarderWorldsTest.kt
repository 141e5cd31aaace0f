package robotran.learning.thorough

import kotlinx.coroutines.test.runTest
import robotran.learning.WorldGallery
import robotran.learning.runIn
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class HarderWorldsTest {
    @Test
    fun `the solution of a world does not solve its harder variations`() = runTest(timeout = 5.minutes) {
        val solved = WorldGallery.worlds.flatMap { world ->
            val solutions = world.lesson?.solutions.orEmpty()
            world.harder.mapNotNull { it.lesson }.filter { harder -> solutions.any { runIn(harder, it, 1).isSolved } }
        }
        assertEquals(emptyList(), solved.map { it.name })
    }
}
