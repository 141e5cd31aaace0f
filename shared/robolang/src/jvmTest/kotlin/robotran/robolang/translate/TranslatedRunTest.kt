package robotran.robolang.translate

import robotran.robolang.Expectations
import robotran.robolang.RobolangRcxProgram
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.testPrograms
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A translated program behaves as in the interpreter. */
class TranslatedRunTest {
    private val texts = testPrograms + documentedPrograms + examplePrograms

    @Test
    fun `every translation makes the calls of the interpreter`() {
        val compared = compare { !isReacting(it) }
        assertTrue(compared >= 150, "only $compared programs were compared")
    }

    @Test
    fun `every translation with behaviours makes the calls of the interpreter, one after the other`() {
        val compared = compare { isReacting(it) }
        assertTrue(compared >= 10, "only $compared programs were compared")
    }

    /** Compares the programs that are [wanted]; returns how many were comparable and equal. */
    private fun compare(wanted: (RobolangRcxProgram) -> Boolean): Int {
        val programs = translatablePrograms.filterValues(wanted) - UNCERTAIN
        val comparison = RunComparison(programs)
        val compared = programs.keys.map { path ->
            comparison.compare(path, Expectations(texts.getValue(path)).sensors)
        }
        assertEquals("", compared.filterIsInstance<Comparison.Different>().joinToString("\n\n") { it.words })
        return compared.count { it == Comparison.Same }
    }

    private companion object {
        /** Their conditions hold for no time, so a brick may or may not detect them. */
        val UNCERTAIN =
            setOf(
                "behaviours/interrupts-between-statements.robo",
                "behaviours/an-action-that-ends-its-own-condition.robo",
            )
    }
}
