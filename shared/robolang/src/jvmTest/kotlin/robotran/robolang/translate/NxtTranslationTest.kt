package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import robotran.language.Language
import robotran.robolang.RobolangProgram
import robotran.robolang.messages.RobolangMessages
import robotran.robolang.testNxt
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Translations for an NXT are Java that knows the class library of leJOS NXJ. */
class NxtTranslationTest {
    @Test
    fun `javac takes every translation for an NXT`() {
        val translations = nxtPrograms.values.mapIndexed { index, program ->
            translateRobolang(
                RobolangProgram.of("P$index", program.checked, testNxt, RobolangMessages.of(Language.ENGLISH)),
            )
        }
        assertTrue(translations.size > 250, "${translations.size} programs")
        assertEquals("", NxjCompiler.problems(translations).take(5).joinToString("\n"))
    }

    @Test
    fun `what javac refuses is found`() {
        val java = "import lejos.nxt.*; public class Wrong { int x = Motor.A.getHeight(); }"
        assertEquals(
            1,
            NxjCompiler.problems(listOf(Translation("Wrong", java, LineMap(emptyList()), brick = BrickKind.RCX))).size,
        )
    }
}
