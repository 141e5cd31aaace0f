package robotran.assignments

import kotlinx.coroutines.test.runTest
import robotran.assignments.collecting.CollectedFile
import robotran.assignments.collecting.CollectingLimits
import robotran.assignments.collecting.Submission
import robotran.assignments.collecting.collectHandIns
import robotran.language.Language
import java.io.ByteArrayOutputStream
import java.util.zip.ZipEntry
import java.util.zip.ZipOutputStream
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** Zips as other programs make them, whole and damaged. */
class MutatedZipsTest {
    private fun zip(vararg files: Pair<String, ByteArray>): ByteArray {
        val bytes = ByteArrayOutputStream()
        ZipOutputStream(bytes).use { zip ->
            for ((path, content) in files) {
                zip.putNextEntry(ZipEntry(path))
                zip.write(content)
                zip.closeEntry()
            }
        }
        return bytes.toByteArray()
    }

    private val beep = "beep\n".encodeToByteArray()

    private suspend fun collect(vararg files: CollectedFile) =
        collectHandIns(files.toList(), ASSIGNMENT, Language.ENGLISH).submissions

    @Test
    fun `deflated files come out`() = runTest {
        val buzz = "buzz\n".encodeToByteArray()
        val older = zip("Anna/prog.robo" to beep, "Bén/" to ByteArray(0), "Bén/prog.robo" to beep, "Bén/b.robo" to buzz)
        val found = collect(CollectedFile("all.zip", older))
        assertEquals(listOf("Anna", "Bén"), found.map { it.name })
        assertEquals(2, assertIs<Submission.Usable>(found[1]).robot.programs.size)
    }

    @Test
    fun `bombs cost their own row and little time`() = runTest(timeout = 2.minutes) {
        val zeros = ByteArray(CollectingLimits.MAXIMUM_FILE_BYTES)
        val files = (1..100).map { "a$it.robo" to zeros }.toTypedArray()
        val flat = zip(*files)
        val nested = zip("1.zip" to zip("2.zip" to flat))
        val found = collect(
            CollectedFile("flat.zip", flat),
            CollectedFile("nested.zip", nested),
            CollectedFile("anna.robo", beep),
            CollectedFile("large.zip", zip("huge.robo" to ByteArray(CollectingLimits.MAXIMUM_FILE_BYTES + 1))),
            CollectedFile("many.zip", zip(*(1..5_001).map { "$it.robo" to beep }.toTypedArray())),
        )
        val reasons = found.associate { it.name to (it as? Submission.Unusable)?.reason.orEmpty() }
        assertEquals("", reasons["anna"])
        for (name in listOf("flat", "nested", "large", "many")) {
            assertTrue("too large" in reasons.getValue(name) || "too many" in reasons.getValue(name), "$reasons")
        }
    }

    @Test
    fun `no damage makes collecting fail, or costs another row`() = runTest(timeout = 5.minutes) {
        val inner = zip("prog.robo" to beep, "arm.java" to "class A {}".encodeToByteArray())
        val whole = zip("Anna_1_assignsubmission_file_/w.zip" to inner, "b/links.txt" to "#p=aAAAA".encodeToByteArray())
        val random = Random(7)
        repeat(3_000) {
            val damaged = whole.copyOf()
            repeat(random.nextInt(1, 8)) { damaged[random.nextInt(damaged.size)] = random.nextInt().toByte() }
            val cut = if (random.nextInt(5) == 0) damaged.copyOf(random.nextInt(damaged.size)) else damaged
            val found = collect(CollectedFile("class.zip", cut), CollectedFile("zoe.robo", beep))
            assertTrue(found.any { it.name == "zoe" && it is Submission.Usable }, "$found")
        }
    }
}
