package robotran.tinyvm.programs

import robotran.tinyvm.JavaCompiler
import robotran.tinyvm.documentedPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** The programs in docs/lejos.md do what the page says. */
class DocumentedProgramsTest {
    @Test
    fun `every program of the page on Java does what its comments say`() {
        assertTrue(documentedPrograms.size >= MIN_PROGRAMS, "The page has only ${documentedPrograms.size} programs.")
        assertEquals("", documentedPrograms.values.flatMap(::differencesOf).joinToString("\n"))
    }

    private fun differencesOf(source: String): List<String> {
        val name = assertNotNull(PUBLIC_CLASS.find(source), source).groupValues[1]
        return differences("$name.java", source, JavaCompiler.compile(mapOf(name to source)))
    }

    private companion object {
        const val MIN_PROGRAMS = 10
        val PUBLIC_CLASS = Regex("""public class (\w+)""")
    }
}
