package robotran.ui.parts

import robotran.editing.READY_ROBOT_WORDS
import robotran.language.Language
import robotran.world.ReadyRobots
import java.io.File
import kotlin.test.Test
import kotlin.test.assertEquals

class ReadyRobotNameTest {
    @Test
    fun `each ready robot has a name in the app, which in English and in the docs is its title`() {
        val titles = ReadyRobots.all.mapValues { it.value.title }
        val names = READY_ROBOT_WORDS.mapValues { (_, name) -> name(Language.ENGLISH) }
        assertEquals(titles, names)
        val rows = Regex(
            """\| `([\w-]+)` \| ([^|]+) \| [A-Z][^|]+ \|""",
        ).findAll(File("../../docs/robots.md").readText())
        assertEquals(titles, rows.associate { it.groupValues[1] to it.groupValues[2] })
    }
}
