package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.language.source.Diagnostic
import robotran.languagesupport.SourceFile
import robotran.nxjlibrary.NxjLibrary
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

/** An NXT makes a new object each time a text of the program is used, so `==` does not compare the letters. */
class TextComparisonsTest {
    private suspend fun warnings(statements: String): List<Diagnostic> =
        compiledForNxt(nxtProgram("String mode = args.length > 0 ? args[0] : \"line\";\n$statements")).warnings

    private suspend fun warning(statements: String): Diagnostic = warnings(statements).single()

    @Test
    fun `texts that are compared as objects are told with what to write`() = runTest {
        val warning = warning("if (mode == \"line\") LCD.clear();")
        assertEquals(9, warning.range?.line)
        assertEquals("mode == \"line\"", warning.text)
        assertContains(warning.message, "\"==\"")
        assertAdvice("Compare the letters: mode.equals(\"line\").", warning)
        assertEquals("mode.equals(\"line\")", assertNotNull(warning.fix).replacement)
    }

    @Test
    fun `texts that are to differ are told, too`() = runTest {
        val warning = warning("while (args[0].trim() != mode) LCD.clear();")
        assertContains(warning.message, "\"!=\"")
        assertEquals("!args[0].trim().equals(mode)", assertNotNull(warning.fix).replacement)
    }

    @Test
    fun `brackets stay`() = runTest {
        val fix = assertNotNull(warning("boolean is = !((mode + 1) == (\"a\" + mode));").fix)
        assertEquals("(mode + 1).equals((\"a\" + mode))", fix.replacement)
    }

    @Test
    fun `where no call can stand, only the hint tells what to write`() = runTest {
        val warning = warning("boolean is = mode + 1 == \"line1\";")
        assertEquals(null, warning.fix)
        assertAdvice("Compare the letters: a.equals(b).", warning)
    }

    @Test
    fun `null and constants may be compared, and so may other objects`() = runTest {
        val allowed = "boolean is = mode == null; is = \"a\" == \"a\"; Object o = mode; is = o == args;" +
            " is = o == mode; is = mode.equals(\"line\"); int n = 1; is = n == 2;"
        assertEquals(emptyList(), warnings(allowed))
    }

    @Test
    fun `the remark is told in all languages`() = runTest {
        val text = nxtProgram("if (args[0] == \"line\") LCD.clear();")
        for ((messages, word) in listOf(
            JavaMessages.of(Language.GERMAN) to "Objekt",
            JavaMessages.of(Language.SPANISH) to "objeto",
        )) {
            val compiler = compiler().withLanguage(messages)
            val sources = listOf(SourceFile("Robot.java", text))
            val result = compiler.compile(sources, NxjLibrary.load().classFiles, target = BrickTarget.LEJOS_NXJ)
            val warning = assertIs<CompilationResult.Success>(result).warnings.single()
            assertContains(warning.message, word)
            assertContains(warning.message, "args[0].equals(\"line\")")
        }
    }
}
