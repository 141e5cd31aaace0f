package robotran.programs

import robotran.tinyvm.nxj.NxjExpectations
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A share of the test programs; `thorough` has all. */
class NxjSessionsTest {
    @Test
    fun `programs print in a world what their comments say`() {
        val some = NxjSessions.programs.entries.toList().every(SHARE).associate { it.toPair() }
        assertEquals("", NxjSessions().differences(some))
    }

    @Test
    fun `every program of the page on Java for an NXT prints what its comments say`() {
        val programs = documentedNxjPrograms.values.associateBy { source ->
            checkNotNull(PUBLIC_CLASS.find(source)) { source }.groupValues[1] + ".java"
        }
        assertTrue(programs.size >= DOCUMENTED, "${programs.size} programs")
        assertTrue(programs.values.all { NxjExpectations(it).printed.isNotEmpty() })
        assertEquals("", NxjSessions().differences(programs))
    }

    private companion object {
        const val SHARE = 8
        const val DOCUMENTED = 6
        val PUBLIC_CLASS = Regex("""public class (\w+)""")
    }
}
