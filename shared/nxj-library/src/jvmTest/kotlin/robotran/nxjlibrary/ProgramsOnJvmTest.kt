package robotran.nxjlibrary

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The expectations of the test programs are true: the JDK's own compiler and JVM do the same. */
class ProgramsOnJvmTest {
    @Test
    fun `programs that need no brick do on the JVM what their comments say`() {
        val programs = testPrograms.filterValues { ProgramExpectations(it).needsNoBrick }
        assertTrue(programs.size >= FEWEST, "${programs.size} programs")
        JdkCompiler().use { compiler ->
            for ((path, source) in programs.toSortedMap()) {
                val expected = ProgramExpectations(source)
                val program = ProgramOnJvm(path, source, compiler).apply { run() }
                assertEquals(expected.printed.joinToString("\n"), program.printed.joinToString("\n"), path)
                assertEquals(expected.failures, program.failures, path)
            }
        }
    }

    @Test
    fun `every program expects something`() {
        val silent = testPrograms.filterValues { source -> MARKS.none { it in source } }
        assertEquals(emptySet(), silent.keys)
    }

    private companion object {
        const val FEWEST = 90
        val MARKS = listOf("// expect", "// screen", "// takes", "// runs on after")
    }
}
