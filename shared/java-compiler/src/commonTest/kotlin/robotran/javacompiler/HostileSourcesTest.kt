package robotran.javacompiler

import kotlinx.coroutines.test.runTest
import robotran.javacompiler.ecj.JavaSource
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertIs

class HostileSourcesTest {
    @Test
    fun `sources that are too long are not read`() = runTest {
        assertContains(diagnostics("/*" + "x".repeat(200_000) + "*/").single().message, "characters")
        assertContains(diagnostics(program("int x = 1;\n".repeat(100_000))).single().message, "characters")
    }

    @Test
    fun `sources as long as they may be are compiled or told about`() = runTest {
        val texts = listOf(
            "int x = 0;\n" + "x = x + 1;\n".repeat(5_000),
            "int x = 0;\n" + "x = y1;\n".repeat(20_000),
            "wrng();\n".repeat(20_000),
            "%&$! ".repeat(30_000),
            "\\u0041 ".repeat(25_000),
            "String s = \"" + "x".repeat(150_000) + "\";",
            "/*" + "*".repeat(150_000),
            "\"" + "\\".repeat(150_000),
            "\"\n".repeat(60_000),
            "long a = 1;" + "a = a % a;\n".repeat(15_000),
        )
        texts.forEach { assertIs<CompilationResult>(compile(program(it))) }
        val files = List(100) {
            JavaSource(
                "Wrong$it.java",
                "class Wrong$it { " + "int f$it() { return lenght; } ".repeat(50) + "}",
            )
        }
        assertIs<CompilationResult.Rejected>(compiler().compile(files, library))
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
            )
        texts.forEach { assertIs<CompilationResult>(compile(it)) }
    }

    @Test
    fun `classes above each other in a circle are refused`() = runTest {
        diagnostics("class Robot extends B { } class B extends Robot { }")
    }
}
