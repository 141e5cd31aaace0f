package robotran.robolang.translate

import robotran.robolang.RobolangProgram
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.messages.EnglishRobolangMessages
import robotran.robolang.testNxt
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertTrue

/** Translations for an NXT are Java that knows the class library of leJOS NXJ. */
class NxtTranslationTest {
    @Test
    fun `javac takes every translation for an NXT`() {
        val translations = nxtPrograms.values.mapIndexed { index, program ->
            translateRobolang(RobolangProgram.of("P$index", program.checked, testNxt, EnglishRobolangMessages))
        }
        assertTrue(translations.size > 250, "${translations.size} programs")
        assertEquals("", NxjCompiler.problems(translations).take(5).joinToString("\n"))
    }

    @Test
    fun `javac takes programs made at random for an NXT`() {
        val translations = (0 until RANDOM_PROGRAMS).map { number ->
            val text = ProgramWriter(Random(number), isForNxt = true).write()
            val result = compileRobolang("P$number", text, testNxt)
            translateRobolang(assertIs<RobolangResult.Ready>(result, "$result\n$text").program)
        }
        assertEquals("", NxjCompiler.problems(translations).take(5).joinToString("\n"))
    }

    @Test
    fun `what javac refuses is found`() {
        val java = "import lejos.nxt.*; public class Wrong { int x = Motor.A.getHeight(); }"
        assertEquals(1, NxjCompiler.problems(listOf(Translation("Wrong", java, LineMap(emptyList())))).size)
    }

    private companion object {
        const val RANDOM_PROGRAMS = 200
    }
}
