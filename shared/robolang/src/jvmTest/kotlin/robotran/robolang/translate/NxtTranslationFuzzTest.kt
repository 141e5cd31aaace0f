package robotran.robolang.translate

import robotran.language.Language
import robotran.language.fuzz.Fuzzing
import robotran.robolang.RobolangResult
import robotran.robolang.compileRobolang
import robotran.robolang.fuzz.ProgramWriter
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.testNxt
import kotlin.random.Random
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertIs

class NxtTranslationFuzzTest {
    @Test
    fun `javac takes programs made at random for an NXT`() {
        val translations = (1..Fuzzing.share(200, atLeast = 20)).map { number ->
            val text = ProgramWriter(Random(Fuzzing.seed + number), isForNxt = true).write()
            val result = compileRobolang("P$number", text, testNxt, messages = RobolangMessages.of(Language.ENGLISH))
            translateRobolang(assertIs<RobolangResult.Success>(result, "$result\n$text").program)
        }
        assertEquals("", NxjCompiler.problems(translations).take(5).joinToString("\n"))
    }
}
