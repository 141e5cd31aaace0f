package robotran.robolang.translate

import robotran.language.Language
import robotran.language.fuzz.Fuzzing
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.rcxProgram
import robotran.robolang.testTarget
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** A translated program that was made at random behaves as in the interpreter. */
class TranslationFuzzTest {
    @Test
    fun `programs made at random do the same in Java, and the linker of leJOS takes them`() {
        val programs = (1..randomPrograms).associate { number ->
            val text = ProgramWriter(Random(Fuzzing.seed + number)).write()
            "program $number of seed ${Fuzzing.seed}" to
                assertIs<RobolangResult.Success>(
                    compileRobolang("random", text, testTarget, messages = RobolangMessages.of(Language.ENGLISH)),
                    text,
                ).rcxProgram
        }
        val comparison = RunComparison(programs)
        val problems = comparison.classes.filterKeys { it.startsWith("P") }.values.flatMap(::tinyVmErrors)
        // Some programs have more constants and names than a class on the brick can have; see docs/lejos.md.
        assertEquals("", problems.filterNot { it.endsWith(" ldc_w") }.joinToString("\n"))
        val compared = programs.filterValues { !isReacting(it) }.keys.map { comparison.compare(it, emptyList()) }
        assertEquals(emptyList(), compared.filterIsInstance<Comparison.Different>())
        assertTrue(compared.count { it == Comparison.Same } >= randomPrograms / 4)
    }

    private companion object {
        val randomPrograms = Fuzzing.share(500)
    }
}
