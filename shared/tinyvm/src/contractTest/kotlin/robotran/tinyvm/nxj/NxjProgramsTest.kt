package robotran.tinyvm.nxj

import kotlinx.coroutines.test.TestResult
import kotlinx.coroutines.test.runTest
import robotran.nxjlibrary.NxjLibrary
import robotran.tinyvm.compiledNxjPrograms
import robotran.tinyvm.nxjPrograms
import kotlin.io.encoding.Base64
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue
import kotlin.time.Duration.Companion.minutes

/** The class files of the test program at [path], by name. */
internal fun nxjClassFilesOf(path: String): Map<String, ByteArray> =
    compiledNxjPrograms.filterKeys { it.startsWith("$path/") }
        .entries.associate { it.key.removePrefix("$path/").removeSuffix(".class") to Base64.decode(it.value) }

/** Runs the test programs of the class library of an NXT on the virtual brick. */
class NxjProgramsTest {
    private fun check(vararg folders: String): TestResult = runTest(timeout = LONGEST) {
        val library = NxjLibrary.load().classFiles
        val programs = nxjPrograms.filterKeys { it.substringBefore('/') in folders }
        assertTrue(programs.isNotEmpty(), "There are no programs in ${folders.toList()}.")
        val differences = programs.flatMap { (path, source) ->
            nxjDifferences(path, source, nxjClassFilesOf(path), library)
        }
        assertEquals("", differences.joinToString("\n"))
    }

    @Test
    fun `all programs are run`() {
        val folders = setOf("forgiving", "io", "lang", "language", "lejosutil", "nxt", "robotics", "threads", "util")
        assertEquals(folders, nxjPrograms.keys.map { it.substringBefore('/') }.toSet())
    }

    @Test
    fun `programs about the Java language do what they say`() = check("language")

    @Test
    fun `programs about what java lang and java io have do what they say`() = check("lang", "io")

    @Test
    fun `programs about collections and helpers do what they say`() = check("util", "lejosutil")

    @Test
    fun `programs with what leJOS NXJ lacks do what they say`() = check("forgiving")

    @Test
    fun `programs about threads do what they say`() = check("threads")

    @Test
    fun `programs about motors sensors display and buttons do what they say`() = check("nxt")

    @Test
    fun `programs about pilots behaviours and detectors do what they say`() = check("robotics")

    private companion object {
        val LONGEST = 10.minutes
    }
}
