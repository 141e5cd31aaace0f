package robotran.tinyvm.nxj

import robotran.tinyvm.nxjPrograms
import java.io.ByteArrayOutputStream
import java.io.File
import java.io.PrintStream
import java.lang.reflect.InvocationTargetException
import java.net.URLClassLoader
import java.nio.file.Files
import javax.tools.ToolProvider
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The expectations of the test programs for an NXT hold on the JVM of a computer, too, unless they say otherwise. */
class JvmDifferenceTest {
    @Test
    fun `a computer prints the same`() {
        val programs = nxjPrograms.filterValues { !NxjExpectations(it).isOnlyHere && "import lejos" !in it && "// screen " !in it }
        assertTrue(programs.size >= FEWEST_PROGRAMS, "There are only ${programs.size} programs.")
        val differences = programs.mapNotNull { (path, source) ->
            val expected = NxjExpectations(source)
            val printed = printedBy(path.substringAfterLast('/'), source)
            val wanted = expected.printed + expected.failures.map { it.first }
            "$path prints $printed instead of $wanted".takeIf { printed != wanted }
        }
        assertEquals("", differences.joinToString("\n"))
    }

    /** The lines that the program prints, and the name of the exception that main does not catch. */
    private fun printedBy(fileName: String, source: String): List<String> {
        val folder = Files.createTempDirectory("program").toFile()
        try {
            val file = File(folder, fileName).apply { writeText(source) }
            val result = ToolProvider.getSystemJavaCompiler()
                .run(null, null, null, "-source", "8", "-target", "8", "-nowarn", "-Xlint:-options", "-d", folder.path, file.path)
            check(result == 0) { "$fileName does not compile" }
            val printed = ByteArrayOutputStream()
            val before = System.out
            System.setOut(PrintStream(printed, true))
            var thrown: Throwable? = null
            try {
                URLClassLoader(arrayOf(folder.toURI().toURL()), null).use { loader ->
                    val main = loader.loadClass(fileName.removeSuffix(".java")).getDeclaredMethod("main", Array<String>::class.java)
                    main.isAccessible = true
                    main.invoke(null, emptyArray<String>())
                }
            } catch (failed: InvocationTargetException) {
                thrown = failed.targetException
            } finally {
                System.setOut(before)
            }
            val lines = printed.toString().replace("\r", "").removeSuffix("\n").ifEmpty { null }?.lines().orEmpty()
            return lines + listOfNotNull(thrown?.javaClass?.simpleName)
        } finally {
            folder.deleteRecursively()
        }
    }

    private companion object {
        const val FEWEST_PROGRAMS = 6
    }
}
