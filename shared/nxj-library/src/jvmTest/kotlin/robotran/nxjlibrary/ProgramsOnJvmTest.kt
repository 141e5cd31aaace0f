package robotran.nxjlibrary

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** The expectations of the test programs are true: the JDK's own compiler and JVM do the same. */
class ProgramsOnJvmTest {
    @Test
    fun `programs that need no brick do on the JVM what their comments say`() {
        val plain = testPrograms.filterValues { ProgramExpectations(it).needsNoBrick }
        assertTrue(plain.size >= FEWEST, "${plain.size} programs")
        for ((path, source) in plain.toSortedMap()) {
            val expected = ProgramExpectations(source)
            val (prints, failures) = ProgramOnJvm(path, source).run()
            assertEquals(expected.prints.toSortedMap(), prints.toSortedMap(), path)
            assertEquals(expected.failures, failures, path)
        }
    }

    @Test
    fun `every program expects something`() {
        val silent = testPrograms.filterValues { "// prints" !in it && "// screen" !in it }
        assertEquals(emptySet(), silent.keys)
    }

    private companion object {
        const val FEWEST = 90
    }
}
