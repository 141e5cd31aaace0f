package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.messages.JavaMessages
import robotran.language.Language
import robotran.languagesupport.SourceFile
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs
import kotlin.test.assertNotNull

/** Programs that were copied out of a word processor, a mail or a web page. */
class PastedCharactersTest {
    @Test
    fun `each pasted character is told, with a fix for its line`() = runTest {
        val lines = mapOf(
            "String s = \u201Ehi\u201D;" to "String s = \"hi\";",
            "String s = \u201Cit\u2019s {\u201D + \u00ABso\u00BB;" to "String s = \"it\u2019s {\" + \"so\";",
            "char c = \u2018a\u2019;" to "char c = 'a';",
            "int x = 3 \u2212 \u20131;" to "int x = 3 - -1;",
            "Motor.A.setPower(\u00A07);" to "Motor.A.setPower( 7);",
            "Motor.A.\u200Bstop();" to "Motor.A.stop();",
            "Motor.A.st\u00ADop();" to "Motor.A.stop();",
            "boolean b = 1 \u2264 2 && 3 \u2260 4;" to "boolean b = 1 <= 2 && 3 != 4;",
            "int y = 2 \u00D7 3\uFF1B" to "int y = 2 * 3;",
            "\uFF2Dotor.A.stop();" to "Motor.A.stop();",
        )
        for ((written, meant) in lines) {
            val text = program("int before = 0;\n$written\nint behind = before;")
            val diagnostic = diagnostics(text).single()
            assertEquals(5, diagnostic.range?.line, written)
            assertEquals(
                program("int before = 0;\n$meant\nint behind = before;"),
                withFix(text, assertNotNull(diagnostic.fix)),
            )
            compiled(program("int before = 0;\n$meant\nint behind = before;"))
        }
    }

    @Test
    fun `other mistakes beside them are told as ever`() = runTest {
        val all = diagnostics(program("int x = 3 \u2212 1;\nint y = 2\nMotor.A.foo();\nx \u2264 3;"))
        assertEquals(listOf(4, 5, 7), all.map { it.range?.line })
        assertContains(all[1].message, "Put a \";\"")
    }

    @Test
    fun `comments and texts may have any characters`() = runTest {
        compiled(program("String s = \"\u201Ehi\u201D \u2264 \u00A0\"; // it\u2019s \u2013 so\n/* \u2026 \u00D7 */"))
        assertEquals(
            listOf(5),
            diagnostics(program("String s = \"\u201Ehi\u201C\"; // it\u2019s\nint x = 1")).map { it.range?.line },
        )
    }

    @Test
    fun `they are told on an NXT and in other languages, too`() = runTest {
        assertContains(nxtDiagnostic("System.out.println(\u201Chi\u201D);").message, "curly quotation mark")
        val german = compiler().withLanguage(JavaMessages.of(Language.GERMAN)).compile(
            listOf(SourceFile("Robot.java", program("int x = \u22121;"))),
            library,
            target = BrickTarget.LEJOS_RCX,
        )
        assertContains(assertIs<CompilationResult.Failure>(german).diagnostics.single().message, "Schreib \"-\"")
    }

    @Test
    fun `comparisons of other languages get Java's signs`() = runTest {
        val signs = mapOf("=<" to "<=", "=>" to ">=", "<>" to "!=", "===" to "==")
        for ((written, meant) in signs) {
            assertEquals("int x = 1; if (x $meant 2) { }", fixedStatements("int x = 1; if (x $written 2) { }"))
        }
    }
}
