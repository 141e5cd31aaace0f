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

/** The class files of the test program at [path], by name. */
internal fun nxjClassFilesOf(path: String): Map<String, ByteArray> =
    compiledNxjPrograms.filterKeys { it.startsWith("$path/") }
        .entries.associate { it.key.removePrefix("$path/").removeSuffix(".class") to Base64.decode(it.value) }

/** Runs the test programs of the class library of an NXT on the virtual machine. */
class NxjProgramsTest {
    private fun check(folder: String): TestResult = runTest {
        val library = NxjLibrary.load().classFiles
        val programs = nxjPrograms.filterKeys { it.startsWith("$folder/") }
        assertTrue(programs.isNotEmpty(), "There are no programs in $folder.")
        val differences = programs.flatMap { (path, source) ->
            if (folder in ON_BRICK) {
                brickDifferences(path, source, nxjClassFilesOf(path), library)
            } else {
                nxjDifferences(path, source, nxjClassFilesOf(path), library)
            }
        }
        assertEquals("", differences.joinToString("\n"))
    }

    @Test
    fun `all programs are run`() {
        assertEquals(setOf("language", "threads") + ON_BRICK, nxjPrograms.keys.map { it.substringBefore('/') }.toSet())
    }

    @Test
    fun `programs about motors sensors display and buttons do what they say`() = check("nxt")

    @Test
    fun `programs about the Java language do what they say`() = check("language")

    @Test
    fun `programs about threads do what they say`() = check("threads")

    private companion object {
        /** The folders whose programs need a brick. */
        val ON_BRICK = setOf("nxt")
    }
}
