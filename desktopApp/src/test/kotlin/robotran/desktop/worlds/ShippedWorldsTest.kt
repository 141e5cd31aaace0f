package robotran.desktop.worlds

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class ShippedWorldsTest {
    @Test
    fun `there are enough of them, each with a title and a task in two sentences`() {
        assertTrue(ShippedWorlds.withGoals.size >= 15, "only ${ShippedWorlds.withGoals.keys}")
        assertEquals(ShippedWorlds.all.size, ShippedWorlds.all.values.map { it.title }.toSet().size)
        for ((name, world) in ShippedWorlds.withGoals) {
            assertEquals(2, Regex("""[.?](?= |$)""").findAll(world.task).count(), "$name: ${world.task}")
        }
    }
}
