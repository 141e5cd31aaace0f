package robotran.ui.robot

import kotlinx.coroutines.runBlocking
import org.jetbrains.compose.resources.getString
import robotran.world.ReadyRobots
import java.util.Locale
import kotlin.test.Test
import kotlin.test.assertEquals

class ReadyRobotNameTest {
    @Test
    fun `each ready robot has a name in the app, in English its title`() {
        val before = Locale.getDefault()
        Locale.setDefault(Locale.ENGLISH)
        try {
            val names = READY_ROBOT_WORDS.mapValues { runBlocking { getString(it.value) } }
            assertEquals(ReadyRobots.all.mapValues { it.value.title }, names)
        } finally {
            Locale.setDefault(before)
        }
    }
}
