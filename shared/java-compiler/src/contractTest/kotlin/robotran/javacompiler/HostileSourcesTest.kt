package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertIs

class HostileSourcesTest {
    @Test
    fun `sources that are too long are not read`() = runTest {
        assertContains(diagnostics("/*" + "x".repeat(200_000) + "*/").single().message, "characters")
        assertContains(diagnostics(program("int x = 1;\n".repeat(100_000))).single().message, "characters")
    }

    @Test
    fun `too much inside each other is refused`() = runTest {
        val deep = listOf(
            "int x = " + "(".repeat(5_000) + "1" + ")".repeat(5_000) + ";",
            "{".repeat(5_000) + "}".repeat(5_000),
            "boolean b = " + "!".repeat(20_000) + "true;",
            "int x = 1" + " + 1".repeat(20_000) + ";",
            "int y = 0; int x = y" + " + y".repeat(20_000) + ";",
            "if (true) ".repeat(5_000) + ";",
            "int x = 0; if (x == 0) { }" + " else if (x == 1) { }".repeat(5_000),
            "int" + "[]".repeat(20_000) + " x;",
            "\\u0028".repeat(5_000),
        )
        deep.forEach {
            assertContains(
                diagnostics(program(it)).joinToString { diagnostic ->
                    diagnostic.message
                },
                "inside each other",
            )
        }
    }

    @Test
    fun `what is deep but not too deep is compiled`() = runTest {
        compiled(program("int y = 1; int x = y" + " + y".repeat(450) + ";"))
        compiled(program("int x = " + "(".repeat(90) + "1" + ")".repeat(90) + ";"))
        compiled(program("int x = 0; if (x == 0) { }" + " else if (x == 1) { }".repeat(400)))
    }

    @Test
    fun `divisions that have no result are left to the brick`() = runTest {
        val divisions =
            listOf("1 / 0", "1 % 0", "-2147483648 / -1", "-2147483648 % -1", "'a' / 0", "(byte) 1 / (short) 0")
        divisions.forEach { compiled(program("int x = $it;")) }
        listOf("1L / 0L", "1L % 0L", "-9223372036854775808L / -1L").forEach { compile(program("long x = $it;")) }
        listOf("1 / 0.0", "1 % 0.0f").forEach { compile(program("double x = $it;")) }
    }

    @Test
    fun `texts that double again and again do not fill the memory`() = runTest {
        val doubling = (1..40).joinToString("\n") { "static final String S$it = S${it - 1} + S${it - 1};" }
        diagnostics("class Robot {\nstatic final String S0 = \"0123456789\";\n$doubling\n}")
    }

    @Test
    fun `a finally that is copied into copies again and again is refused at its line`() = runTest {
        val nested = "try { f(); } finally {\n".repeat(24) + "f();" + "}".repeat(24)
        val ways = "while (true) try {" + "if (a == null) return; if (a.length > 1) break;".repeat(300) +
            "}\nfinally {" + "f();".repeat(300) + "}"
        for (statements in listOf(nested, ways)) {
            val diagnostic = nxtDiagnosticOf(finallyProgram(statements))
            assertContains(diagnostic.message, "copies of copies")
            assertEquals("finally", diagnostic.text)
        }
    }

    @Test
    fun `a finally as programs have it is compiled, and any on an RCX, which has its code once`() = runTest {
        compiledForNxt(finallyProgram("try { f(); } finally { ".repeat(5) + "f();" + "}".repeat(5)))
        compiledForNxt(
            finallyProgram("while (true) try {" + "if (a == null) return;".repeat(40) + "} finally { f(); f(); }"),
        )
        compiled("class Robot { void f() {" + "try { f(); } finally { ".repeat(24) + "f();" + "}".repeat(24) + "} }")
    }

    @Test
    fun `sources that would keep the compiler for very long are refused at the method or class`() = runTest {
        fun times(count: Int, part: (Int) -> String) = List(count, part).joinToString("")
        val program = "public class Robot { static class P<A, B> { }\nstatic <T> P<T, T> pair(T t) { return null; }\n"
        val expensive = mapOf(
            program + "void doubled() { Object o = " + "pair(".repeat(40) + "this" + ")".repeat(40) + "; } }" to
                "doubled",
            "public class Robot { static class P<A, B> { }\n" +
                "static class G<T> { G<P<T, T>> next() { return null; } }\n" +
                "void grown() { Object o = new G<String>()" + ".next()".repeat(30) + "; int i = o.foo(); " +
                "int k = new G<String>()" + ".next()".repeat(30) + "; } }" to "grown",
            "public class Robot { " + times(400) { "static class C$it { } " } +
                times(400) { "Robot(C$it c) { } " } + "int n; { " + "n++; ".repeat(15_000) + "} }" to "Robot",
        )
        for ((text, place) in expensive) {
            val diagnostic = nxtDiagnosticOf(text)
            assertContains(diagnostic.message, "too long for \"$place\"")
            assertEquals(place, diagnostic.text)
        }
    }

    @Test
    fun `what is too much before any method is looked at is told of the file`() = runTest {
        val text = "public class Robot { enum Named { " + List(12_000) { "E$it, " }.joinToString("") + "} }"
        assertContains(nxtDiagnosticOf(text).message, "too long for \"Robot.java\"")
    }

    @Test
    fun `a program that is refused for its work leaves the next one all of it`() = runTest {
        nxtDiagnosticOf("public class Robot { enum Named { " + List(12_000) { "E$it, " }.joinToString("") + "} }")
        compiledForNxt(nxtProgram("Motor.A.forward();"))
    }

    @Test
    fun `more imports or classes than a program ever has are refused`() = runTest {
        assertContains(
            diagnostics("import java.util.Vector;\n".repeat(301) + "class Robot { }").single().message,
            "300 imports",
        )
        val classes = List(501) { "class C$it extends C${it + 1} { }" }.joinToString("\n")
        assertContains(diagnostics("$classes class C501 { }").single().message, "500 classes")
    }

    @Test
    fun `a method that does not fit into a class file is told so`() = runTest {
        assertContains(diagnostic("int x = 0;" + "x = x * x;".repeat(17_000)).message, "65535 bytes")
    }

    @Test
    fun `no text whatever makes the compiler fail`() = runTest {
        val texts =
            listOf(
                "",
                "\u0000",
                "\"",
                "'",
                "/*",
                "\\u",
                "class",
                "}",
                "class Robot extends Robot { }",
                "package ;",
                "import ;",
                "\uD800",
                "==",
                "if",
                "stop();",
                "class Robot { stop(",
                "class Robot { void f() { for (;;",
            )
        texts.forEach { assertIs<CompilationResult>(compile(it)) }
        texts.forEach { assertIs<CompilationResult>(compileForNxt(it)) }
    }

    private fun finallyProgram(statements: String) =
        "public class Robot { static void f() { }\npublic static void main(String[] a) {\n$statements\n} }"

    @Test
    fun `classes above each other in a circle are refused`() = runTest {
        diagnostics("class Robot extends B { } class B extends Robot { }")
    }
}
