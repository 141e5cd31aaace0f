package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.language.source.Diagnostic
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertNotNull

/** What is in the wrong place is told there, in the words of its mistake, and nothing that only follows from it. */
class StructureErrorsTest {
    private suspend fun only(text: String): Diagnostic = diagnostics(text).single()

    @Test
    fun `a method in a method is told to be moved out`() = runTest {
        val methods = listOf("public static void turn()", "static int twice(int a)", "void turn(int a)", "int[] all()")
        for (method in methods) {
            val body = if (method.startsWith("static int")) "return 2 * a;" else "Motor.A.stop();"
            val diagnostic = diagnostics(program("Motor.A.forward();\n$method {\n$body\n}\nturn();")).single()
            assertEquals(5, diagnostic.range?.line)
            assertContains(diagnostic.message, "inside another method")
        }
        compiled(program("new Thread() { public void run() { } }.start();"))
    }

    @Test
    fun `a method that is not closed is told, not that the next one is inside of it`() = runTest {
        val text = "class Robot {\nvoid go() {\nint x = 3;\nvoid stop() {\n}\n}"
        assertContains(only(text).message, "without its \"}\"")
    }

    @Test
    fun `what stands beside the class is told with the class it belongs into`() = runTest {
        val diagnostic = only("import josx.platform.rcx.*;\n\nvoid drive() {\n}\n\npublic class Robot {\n}\n")
        assertEquals(3, diagnostic.range?.line)
        assertContains(diagnostic.message, "in no class")
        assertContains(diagnostic.message, "class \"Robot\"")
        val alone = only("import josx.platform.rcx.*;\n\npublic static void main(String[] args) {\nLCD.clear();\n}\n")
        assertEquals(3, alone.range?.line)
        assertAdvice("Write \"public class Robot {\" above it, and \"}\" at the very end.", alone)
        assertContains(only("LCD.clear();\n").message, "public static void main")
    }

    @Test
    fun `statements in a class are told at the first of them`() = runTest {
        val statements = listOf(
            "if (true) Motor.A.stop();",
            "while (true) { Motor.A.stop(); }",
            "for (int i = 0; i < 3; i++) { }",
            "x = 4;\nLCD.showNumber(x);",
            "LCD.showNumber(x);",
            "x++;",
            "stop();",
        )
        for (statement in statements) {
            val diagnostic = only(
                "import josx.platform.rcx.*;\npublic class Robot {\nstatic int x = 3;\n$statement\n" +
                    "public static void main(String[] args) { }\n}",
            )
            assertEquals(4, diagnostic.range?.line, statement)
            assertContains(diagnostic.message, "in none of its methods")
        }
    }

    @Test
    fun `what a class may have is not taken for a statement`() = runTest {
        val members = "int[] a = {1, 2};\nstatic { a(); }\n{ b = 1; }\nRobot() { }\nint b, c = 2;\n" +
            "static void a() { }\njava.util.Vector v = new java.util.Vector() { int size = 3; };\n" +
            "abstract static class C { abstract void d(); }\n"
        compiled("class Robot {\n$members}")
        assertContains(only("class Robot {\n${members}void e() { int f = 1\n}\n}").message, "Put a \";\"")
    }

    @Test
    fun `capital letters at the head of a class are made small together`() = runTest {
        val text = "import josx.platform.rcx.*;\n\nPublic Class Robot {\n    int speed;\n    void go() {\n    }\n}\n"
        val diagnostic = only(text)
        assertEquals(3, diagnostic.range?.line)
        compiled(withFix(text, assertNotNull(diagnostic.fix)))
    }

    @Test
    fun `a class is called with one word`() = runTest {
        val text = "public class Ro bot {\n    int speed;\n}\n"
        val diagnostic = only(text)
        assertContains(diagnostic.message, "one word")
        assertContains(withFix(text, assertNotNull(diagnostic.fix)), "class Robot {")
    }

    @Test
    fun `a condition gets its brackets`() = runTest {
        val diagnostic = diagnostics(program("if Motor.A.isMoving() { Motor.A.stop(); }")).single()
        assertContains(diagnostic.message, "if (light < 40)")
        assertEquals("int i = 3; if (i > 2) { }", fixedStatements("int i = 3; if i > 2 { }"))
        assertEquals("while (true) { }", fixedStatements("while true { }"))
        assertEquals(
            "int i = 3; if (i > 2) { } else if (i > 1) { }",
            fixedStatements("int i = 3; if (i > 2) { } else if i > 1 { }"),
        )
    }

    @Test
    fun `a variable with the name of a word of Java is told`() = runTest {
        for (word in listOf("class", "new", "if", "public")) {
            val diagnostic = diagnostics(program("int $word = 5;")).single()
            assertContains(diagnostic.message, "\"$word\" is a word of Java's own")
        }
    }
}
