package robotran.projects

import kotlinx.coroutines.test.runTest
import robotran.language.Language
import robotran.nxt.storage.FlashMemory
import robotran.nxt.storage.NxtFile
import robotran.simulation.RobotProgramSet
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

private const val MANY = 1_000

private val files = listOf(
    NxtFile("count.txt", byteArrayOf(1, -1, 0, 127)),
    NxtFile("empty", ByteArray(0), attributes = 1),
    NxtFile("long.dat", ByteArray(MANY) { it.toByte() }),
)

/** The full project with files in the flash memory of each robot. */
internal val PROJECT_WITH_FILES = FULL_PROJECT.copy(robots = FULL_PROJECT.robots.map { it.copy(files = files) })

/** What programs have written into the flash memory of an NXT is part of a project. */
class NxtFilesTest {
    private val written = writeProject(PROJECT_WITH_FILES)

    @Test
    fun `files are read as they were written`() {
        val read = loaded(written)
        assertEquals(PROJECT_WITH_FILES, read)
        assertEquals(files[0].content().toList(), read.robots[0].files[0].content().toList())
        assertEquals(FULL_PROJECT, PROJECT_WITH_FILES.withoutFiles())
        assertEquals(writeProject(FULL_PROJECT), writeProject(PROJECT_WITH_FILES.withoutFiles()))
    }

    @Test
    fun `files that are not allowed are refused with their place`() {
        assertEquals("robots[0].flash[0].content must be bytes in Base64.", refusal("\"Af8Afw==\"", "\"?\""))
        assertEquals("robots[0].flash[0] must not have \"size\".", refusal("\"Af8Afw==\"", "\"\", \"size\": 4"))
        assertEquals(
            "robots[0].flash[1].attributes must be a whole number from 0 to 255.",
            refusal("\"attributes\": 1", "\"attributes\": 256"),
        )
        assertContains(
            refusal("\"count.txt\"", "\"${"n".repeat(NxtFile.LONGEST_NAME + 1)}\""),
            "robots[0].flash[0].name",
        )
        val robots = PROJECT_WITH_FILES.robots.map { robot -> robot.copy(files = List(TOO_MANY) { files[1] }) }
        val many = PROJECT_WITH_FILES.copy(robots = robots)
        val described = assertIs<ProjectFileResult.Failure>(readProject(writeProject(many), Language.ENGLISH)).message
        assertContains(described, "robots[0].flash")
        assertEquals("robots[0].flash must be files that fit into an NXT.", refusal("\"count.txt\"", "\"✎\""))
    }

    @Test
    fun `whatever a program writes into the table of files, the project can be read again`() {
        val random = Random(SEED)
        var described = 0
        repeat(TABLES) {
            val flash = FlashMemory(files)
            val table = ByteArray(FlashMemory.PAGE_BYTES)
            flash.readPage(TABLE_PAGE, table)
            repeat(1 + random.nextInt(MOST_CHANGES)) {
                table[SIGN_BYTES + random.nextInt(USED_BYTES)] =
                    random.nextInt().toByte()
            }
            flash.writePage(TABLE_PAGE, table)
            described += flash.files.size
            val robots = PROJECT_WITH_FILES.robots.map { robot -> robot.copy(files = flash.files) }
            assertEquals(flash.files, loaded(writeProject(PROJECT_WITH_FILES.copy(robots = robots))).robots[0].files)
        }
        assertTrue(described > TABLES, "$described files")
    }

    private fun refusal(old: String, new: String): String {
        assertContains(written, old)
        return assertIs<ProjectFileResult.Failure>(
            readProject(written.replaceFirst(old, new), Language.ENGLISH),
        ).message
            .substringAfter(": ")
    }

    @Test
    fun `a run begins with the files, and a link has none`() = runTest {
        val loads =
            loadsWith(PROJECT_WITH_FILES.robots, PROJECT_WITH_FILES.world, List(2) { RobotProgramSet(emptyList()) })
        assertEquals(listOf(files, files), loads.map { it.files })
        val link = assertIs<LinkCreation.Made>(linkOf(PROJECT_WITH_FILES, Language.ENGLISH)).fragment
        val opened = assertIs<LinkResult.OfProject>(openLink(link, Language.ENGLISH))
        assertEquals(FULL_PROJECT, opened.project)
    }

    private companion object {
        const val TOO_MANY = 31
        const val SEED = 2005
        const val TABLES = 200
        const val TABLE_PAGE = 1
        const val SIGN_BYTES = 5
        const val USED_BYTES = 60
        const val MOST_CHANGES = 3
    }
}
