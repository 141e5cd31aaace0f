package robotran.learning

import kotlinx.coroutines.test.runTest
import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.time.Duration.Companion.minutes

class WorldTasksTest {
    @Test
    fun `every solution reaches the goals`() = runTest(timeout = 10.minutes) {
        assertEquals(emptyList(), unsolvedWorlds(1..1))
    }

    @Test
    fun `every world with an NXT has solutions in Robolang and in Java`() {
        val withNxt = WorldGallery.worlds.filter { it.plainWorld.robots.first().description.brick == BrickKind.NXT }
        for (world in withNxt) {
            val solutions = checkNotNull(world.lesson).solutions.map { it.name.substringAfterLast('.') }
            assertEquals(listOf("robo", "java"), solutions, world.name)
        }
        assertEquals(NXT_WORLDS, withNxt.size)
    }

    @Test
    fun `the program that is given reaches the goals nowhere`() = runTest(timeout = 5.minutes) {
        assertEquals(emptyList(), worldTasks.filter { runIn(it, it.program.text).isSolved }.map { it.name })
    }

    private companion object {
        const val NXT_WORLDS = 6
    }
}
