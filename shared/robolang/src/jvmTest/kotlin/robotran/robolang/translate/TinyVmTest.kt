package robotran.robolang.translate

import robotran.brick.kind.BrickKind
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** A translation that javac accepts must also pass the leJOS linker, which supports less of Java. */
class TinyVmTest {
    @Test
    fun `the linker of leJOS takes every translation`() {
        val translations = translatablePrograms.values.mapIndexed { index, program -> translatedAs("P$index", program) }
        val classes = LejosCompiler.compile(translations).filterKeys { NAME.matches(it) }
        assertTrue(classes.size >= translations.size)
        assertEquals("", classes.values.flatMap(::tinyVmErrors).joinToString("\n"))
    }

    @Test
    fun `what the linker refuses is found`() {
        val refused = mapOf(
            "long sum = System.currentTimeMillis() + 1;" to "refuses ladd",
            "float rest = 5.5f; rest %= 2f;" to "refuses frem",
            "int x = (int) System.currentTimeMillis(); switch (x) { case 1: x = 2; }" to "refuses lookupswitch",
            "int[] many = new int[512];" to "512 elements, of which 511 are allowed",
            "int[][] table = new int[2][3];" to "an array of arrays",
            (0..255).joinToString("") { "int x$it = $it;" } to "257 locals, of which 255 are allowed",
            (0..256).joinToString("", "float x = 0f;") { "x += $it.5f;" } to "257 constants, of which 256 are allowed",
        )
        for ((statements, problem) in refused) {
            val java = "public class Refused { public static void main(String[] arguments) { $statements } }"
            val problems =
                tinyVmErrors(
                    LejosCompiler.compile(
                        listOf(Translation("Refused", java, LineMap(emptyList()), brick = BrickKind.RCX)),
                    ).getValue("Refused"),
                )
            assertContains(problems.joinToString("\n"), problem)
        }
    }

    private companion object {
        /** The names of the translated classes, without the leJOS stubs. */
        val NAME = Regex("""P\d+(\$.+)?""")
    }
}
