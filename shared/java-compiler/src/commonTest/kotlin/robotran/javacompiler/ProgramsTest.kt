package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** The programs of the class library and the examples. */
class ProgramsTest {
    @Test
    fun `the mistakes of the test programs are those that their comments name`() = runTest {
        val expected = testPrograms.mapValues { (_, text) -> linesWithErrors(text) }.filterValues { it.isNotEmpty() }
        val found = testPrograms.mapValues { (path, text) ->
            when (val result = compileProgram(path, text)) {
                is CompilationResult.Failure -> result.diagnostics.map { it.range?.line }
                is CompilationResult.Success -> emptyList()
            }
        }.filterValues { it.isNotEmpty() }
        assertEquals(expected, found)
    }

    @Test
    fun `each mistake of the test programs is told in words of our own`() = runTest {
        val described = testPrograms.filterKeys { it.startsWith("mistakes/") }.flatMap { (path, text) ->
            assertIs<CompilationResult.Failure>(compileProgram(path, text)).diagnostics.map { it.message }
        }
        assertTrue(described.none { message -> ECJ_WORDS.any { it in message } }, described.joinToString("\n"))
    }

    @Test
    fun `all examples compile and can be run`() = runTest {
        for ((path, text) in examplePrograms) {
            val result = assertIs<CompilationResult.Success>(compileProgram(path, text), path)
            assertEquals(emptyList(), result.warnings, path)
            assertNull(result.missingMain, path)
        }
    }

    @Test
    fun `the classes of leJOS are compiled to the bytes that the build makes of them`() = runTest {
        val made = mutableMapOf<String, Int>()
        for ((path, text) in librarySources) {
            val result =
                assertIs<CompilationResult.Success>(compiler().compile(listOf(SourceFile(path, text)), library), path)
            made += result.classes.mapValues { it.value.contentHashCode() }
        }
        assertEquals(library.mapValues { it.value.contentHashCode() }, made)
    }

    private suspend fun compileProgram(path: String, text: String) =
        compiler().compile(listOf(SourceFile(path.substringAfterLast('/'), text)), library)

    /** The lines with compiler errors and the lines that the linker rejects; the compiler reports both. */
    private fun linesWithErrors(text: String): List<Int> {
        val named = text.lines().filter {
            it.startsWith("// error ")
        }.map { it.removePrefix("// error ").trim().toInt() }
        val refused = text.lines().mapIndexedNotNull { index, line -> (index + 1).takeIf { "// refused: " in line } }
        return (named + refused).sorted()
    }

    private companion object {
        val ECJ_WORDS = listOf("cannot be resolved", "Syntax error", "undefined", "token", "applicable")
    }
}
