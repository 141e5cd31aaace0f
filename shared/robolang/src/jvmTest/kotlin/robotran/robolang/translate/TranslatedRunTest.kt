package robotran.robolang.translate

import robotran.robolang.Expectations
import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.documentedPrograms
import robotran.robolang.examplePrograms
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.testCalibration
import robotran.robolang.testPrograms
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
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

    @Test
    fun `programs made at random do the same in Java, and the linker of leJOS takes them`() {
        val programs = (0 until RANDOM_PROGRAMS).associate { number ->
            val text = ProgramWriter(Random(number)).write()
            "program $number" to
                assertIs<RobolangResult.Ready>(compileRobolang("random", text, testCalibration), text).program
        }
        val comparison = RunComparison(programs)
        val problems = comparison.classes.filterKeys { it.startsWith("P") }.values.flatMap(::tinyVmProblems)
        // Some programs have more constants and names than a class on the brick can have; see docs/lejos.md.
        assertEquals("", problems.filterNot { it.endsWith(" ldc_w") }.joinToString("\n"))
        val compared = programs.filterValues { !isReacting(it) }.keys.map { comparison.compare(it, emptyList()) }
        assertEquals(emptyList(), compared.filterIsInstance<Comparison.Different>())
        assertTrue(compared.count { it == Comparison.Same } >= RANDOM_PROGRAMS / 4)
    }

    /** Compares the programs that are [wanted]; returns how many were comparable and equal. */
    private fun compare(wanted: (RobolangProgram) -> Boolean): Int {
        val programs = translatablePrograms.filterValues(wanted) - UNCERTAIN
        val comparison = RunComparison(programs)
        val compared = programs.keys.map { path ->
            comparison.compare(path, Expectations(texts.getValue(path)).sensors)
        }
        assertEquals("", compared.filterIsInstance<Comparison.Different>().joinToString("\n\n") { it.words })
        return compared.count { it == Comparison.Same }
    }

    private companion object {
        const val RANDOM_PROGRAMS = 500

        /** Their conditions hold for no time, so a brick may or may not detect them. */
        val UNCERTAIN =
            setOf(
                "behaviours/interrupts-between-statements.robo",
                "behaviours/an-action-that-ends-its-own-condition.robo",
            )
    }
}
