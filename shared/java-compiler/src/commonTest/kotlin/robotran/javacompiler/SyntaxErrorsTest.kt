package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.SourceRange
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

class SyntaxErrorsTest {
    @Test
    fun `a missing semicolon is put in where it belongs`() = runTest {
        val diagnostic = diagnostic("int x = 1\nint y = 2;")
        assertEquals("Put a \";\" at the end of this statement.", diagnostic.message)
        assertEquals(SourceRange(4, 10, 10), diagnostic.range)
        assertEquals("int x = 1;\nint y = 2;", fixedStatements("int x = 1\nint y = 2;"))
        assertEquals("do { } while (true);", fixedStatements("do { } while (true)"))
    }

    @Test
    fun `a semicolon that is missing behind a name is put in, too`() = runTest {
        val statements = "int rounds = 0;\nint i = 1;\nrounds = rounds + i"
        for (rest in listOf("", "\nrounds = 2;", "\nint k = 2;", "\nMotor.A.stop();", " // add")) {
            val diagnostic = diagnostic(statements + rest)
            assertEquals("Put a \";\" at the end of this statement.", diagnostic.message)
            assertEquals(SourceRange(6, 20, 20), diagnostic.range)
            assertEquals("$statements;$rest", fixedStatements(statements + rest))
        }
        assertEquals(
            "for (;;) {\nint a = 1, b = 2;\na = a - b;\n}",
            fixedStatements("for (;;) {\nint a = 1, b = 2;\na = a - b\n}"),
        )
    }

    @Test
    fun `a missing bracket is put in where it belongs`() = runTest {
        assertEquals("if (1 > 0) { }", fixedStatements("if (1 > 0 { }"))
        assertEquals("int[] x = new int[3];", fixedStatements("int[] x = new int[3;"))
    }

    @Test
    fun `a missing brace is told where the next one should have been`() = runTest {
        val text = "class Robot {\nvoid go() {\nint x = 3;\nvoid stop() {\n}\n}"
        val diagnostic = diagnostics(text).single()
        assertEquals(3, diagnostic.range?.line)
        assertContains(diagnostic.message, "without its \"}\"")
        compiled(withFix(text, assertNotNull(diagnostic.fix)))
        val endless = "class Robot {\nvoid go() {\n}\n"
        compiled(withFix(endless, assertNotNull(diagnostics(endless).single().fix)))
    }

    @Test
    fun `a brace too many is told`() = runTest {
        assertContains(diagnostics("class Robot {\n}\n}").single().message, "one too many")
    }

    @Test
    fun `a text that does not end is told and nothing that follows from it`() = runTest {
        val diagnostic = diagnostics(program("int y = 0;\nString t = \"abc;\nif (y > 1) { y = 2; }")).single()
        assertEquals(SourceRange(5, 12, 13), diagnostic.range)
        assertContains(diagnostic.message, "quotation mark")
        assertContains(diagnostics(program("String t = \"a // \\\" b;")).single().message, "quotation mark")
    }

    @Test
    fun `a text between single quotation marks gets double ones`() = runTest {
        assertEquals("String s = \"hello\";", fixedStatements("String s = 'hello';"))
    }

    @Test
    fun `words of other languages are told with Java's own`() = runTest {
        assertEquals("int i = 3; if (i > 2)  { }", fixedStatements("int i = 3; if (i > 2) then { }"))
        assertEquals(
            "int i = 3; if (i > 2) { } else if (i < 1) { }",
            fixedStatements("int i = 3; if (i > 2) { } elseif (i < 1) { }"),
        )
        assertEquals("boolean b = true;", fixedStatements("bool b = true;"))
        assertEquals("boolean b = true;", fixedStatements("boolean b = True;"))
        assertEquals("boolean b = 1 > 2 && 2 > 1;", fixedStatements("boolean b = 1 > 2 and 2 > 1;"))
        assertEquals("Object o = null;", fixedStatements("Object o = NULL;"))
        assertEquals("final int K = 3;", fixedStatements("const int K = 3;"))
    }

    @Test
    fun `capital letters in a word of Java are made small`() = runTest {
        val text = "Public class Robot { }"
        assertEquals("public class Robot { }", withFix(text, assertNotNull(diagnostics(text).first().fix)))
        assertEquals("while (true) { }", fixedStatements("While (true) { }"))
    }

    @Test
    fun `a condition without brackets is told with an example`() = runTest {
        assertContains(diagnostic("int i = 3; if i > 2 { }").message, "if (light < 40)")
        assertContains(diagnostic("int i = 3; while i > 2 { }").message, "brackets")
    }

    @Test
    fun `the parts of a loop have semicolons between them`() = runTest {
        assertContains(diagnostic("for (int i = 0, i < 3, i++) { }").message, "for (int i = 0; i < 4; i++)")
    }

    @Test
    fun `an else without if is told`() = runTest {
        assertContains(diagnostic("int i = 1;\nelse { }").message, "no \"if\"")
    }

    @Test
    fun `a statement outside of any method is told`() = runTest {
        val message = "in none of its methods"
        assertContains(
            diagnostics("import josx.platform.rcx.*;\nclass Robot {\nMotor.A.forward();\n}").first().message,
            message,
        )
        assertContains(memberDiagnostic("int x; x = 3;").message, message)
    }

    @Test
    fun `a program without a class is shown one with the name of its file`() = runTest {
        assertContains(diagnostics("Motor.A.forward();").first().message, "public class Robot {")
        assertContains(diagnostics("void main() { }").first().message, "public class Robot {")
    }

    @Test
    fun `a call without brackets gets them`() = runTest {
        assertEquals("Motor.A.forward();", fixedStatements("Motor.A.forward;"))
    }

    @Test
    fun `a value that nothing is done with is no statement`() = runTest {
        assertContains(diagnostic("int x = 1; x + 3;").message, "nothing happens")
        assertEquals("int x = 1; x = 3;", fixedStatements("int x = 1; x == 3;"))
    }

    @Test
    fun `names are not words of Java nor begin with a digit`() = runTest {
        assertContains(diagnostic("int if = 3;").message, "word of Java's own")
        assertContains(diagnostic("int 3x = 4;").message, "begins with a letter")
    }

    @Test
    fun `arrays get their length where they are made`() = runTest {
        assertContains(diagnostic("int y[3];").message, "new int[3]")
        assertContains(diagnostic("int[] x; x = {1, 2};").message, "new int[] {")
    }

    @Test
    fun `a parameter needs a type`() = runTest {
        assertContains(memberDiagnostic("void go(x) { }").message, "type before it")
    }

    @Test
    fun `a try needs a catch`() = runTest {
        assertContains(diagnostic("try { Thread.sleep(3); }").message, "catch (")
    }
}
