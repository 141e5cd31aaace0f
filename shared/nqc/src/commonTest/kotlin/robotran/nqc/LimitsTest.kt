package robotran.nqc

import robotran.language.Language
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertIs

/** Programs that would never end, or never fit into memory, without limits. */
class LimitsTest {
    @Test
    fun `macros that double each other`() {
        val macros = (1..60).joinToString("") { "#define M$it M${it - 1} M${it - 1}\n" }
        check("#define M0 x++;\nint x;\n${macros}task main() { M60 }", NqcDiagnosticCode.MACROS_TOO_LONG)
    }

    @Test
    fun `empty macros that double each other`() {
        val macros = (1..60).joinToString("") { "#define M$it M${it - 1} M${it - 1}\n" }
        check("#define M0\n${macros}task main() { M60 }", NqcDiagnosticCode.MACROS_TOO_LONG)
    }

    @Test
    fun `a macro that calls its argument with itself`() =
        check("#define F(x) x(x)\ntask main() { F(F) }", NqcDiagnosticCode.MACROS_TOO_LONG)

    @Test
    fun `arguments that double each other`() {
        val calls = "F(".repeat(40) + "1" + ")".repeat(40)
        check("#define F(x) (x + x)\nint a;\ntask main() { a = $calls; }", NqcDiagnosticCode.MACROS_TOO_LONG)
    }

    @Test
    fun `functions that call the next one twice`() {
        val functions = (1..50).joinToString("") { "void f$it() { f${it - 1}(); f${it - 1}(); }\n" }
        check("int x; void f0() { x++; }\n${functions}task main() { f50(); }", NqcDiagnosticCode.PROGRAM_TOO_LONG)
    }

    @Test
    fun `functions without code that call the next one twice`() {
        val functions = (1..50).joinToString("") { "void f$it() { f${it - 1}(); f${it - 1}(); }\n" }
        check("void f0() { }\n${functions}task main() { f50(); }", NqcDiagnosticCode.PROGRAM_TOO_LONG)
    }

    @Test
    fun `arguments that functions double`() {
        val functions = (1..50).joinToString("") { "void f$it(const int &a) { f${it - 1}(a + a); }\n" }
        val program = "int x; void f0(const int &a) { x = a; }\n${functions}task main() { f50(x); }"
        check(program, NqcDiagnosticCode.PROGRAM_TOO_LONG)
    }

    @Test
    fun `a long chain of functions`() {
        val functions = (1..3000).joinToString("") { "void f$it() { f${it - 1}(); }\n" }
        check("void f0() { }\n${functions}task main() { f3000(); }", NqcDiagnosticCode.NESTED_TOO_DEEPLY)
    }

    @Test
    fun `exclusive ors compute both sides twice`() {
        val ors = (1..60).joinToString(" ^ ") { "x" }
        check("int x, y; task main() { y = $ors; }", NqcDiagnosticCode.PROGRAM_TOO_LONG)
    }

    @Test
    fun `a very long sum`() {
        val sum = (1..50_000).joinToString(" + ") { "x" }
        check("int x, y; task main() { y = $sum; }", NqcDiagnosticCode.NESTED_TOO_DEEPLY)
    }

    @Test
    fun `very many brackets`() =
        check("int x; task main() { x = ${"(".repeat(50_000)}", NqcDiagnosticCode.NESTED_TOO_DEEPLY)

    @Test
    fun `very many signs`() =
        check("int x; task main() { x = ${"-".repeat(50_001)}1;", NqcDiagnosticCode.NESTED_TOO_DEEPLY)

    @Test
    fun `very many blocks`() = check("task main() ${"{".repeat(50_000)}", NqcDiagnosticCode.NESTED_TOO_DEEPLY)

    @Test
    fun `very many branches`() =
        check("int x; task main() { ${"if (x) x = 1; else ".repeat(5_000)} }", NqcDiagnosticCode.NESTED_TOO_DEEPLY)

    @Test
    fun `a file that includes itself`() =
        check("#include \"x.nqc\"\ntask main() { }", NqcDiagnosticCode.TOO_MANY_INCLUDES)

    @Test
    fun `more than a brick can hold`() =
        check("int x; task main() { ${"x = x + 1;\n".repeat(10_000)} }", NqcDiagnosticCode.PROGRAM_TOO_LONG)

    @Test
    fun `a file that is too long`() = check("// ${"x".repeat(600_000)}", NqcDiagnosticCode.SOURCE_TOO_LONG)

    private fun check(source: String, code: NqcDiagnosticCode) {
        val result =
            assertIs<NqcResult.Failure>(compileNqc("x.nqc", source, messages = NqcMessages.of(Language.ENGLISH)))
        assertContains(result.diagnostics.map { it.code }, code, result.diagnostics.take(5).joinToString("\n"))
    }
}
