package robotran.nqc

import robotran.language.Language
import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.messages.NqcMessages
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class DiagnosticsTest {
    @Test
    fun `fixes lead to programs without mistakes`() {
        val programs = listOf(
            "task main() { OnFwd(OUT_A) }",
            "task main() { OnFwd(OUT_A)\nWait(1); }",
            "task main() { SetSensor(SENSOR_1, SENSOR_TOUCH); if (SENSOR_1 = 1) Off(OUT_A); }",
            "int count; task main() { cont = 1; }",
            "task main() { OnFdw(OUT_A); }",
            "task main() { OnFwd(out_a); }",
            "task Main() { }",
            "task main() { start othr; } task other() { }",
            "inline void f() { } task main() { f(); }",
            "int f() { } task main() { f(); }",
            "task main() { Wait(1);",
            "task main() { } }",
            "#defien A 1\ntask main() { Wait(1); }",
            "int x; task main() { if (x); x = 1; }",
            "int x; task main() { while (x < 3); { x++; } }",
            "int x; task main() { switch (x) { case 1 x = 2; } }",
            "int x; task main() { switch (x) { case 1: } }",
            "int x; task main() { x = (1 + 2; }",
            "task main() { Wait(0.5); }",
            "task main() { PlayTone(440, .5); }",
            "task main() { OnFor(OUT_A + OUT_C, 1.25); }",
            "task main() { drive; } task drive() { }",
            "task main() { drive(); } task drive() { }",
            "task main() { s; } sub s() { }",
            "task main() { ClearMessage; }",
            "Task main() { }",
            "taks main() { }",
            "VOID f() { } task main() { f(); }",
            "Int x; task main() { x = 1; }",
            "task main() { Int x = 1; }",
            "float x; task main() { x = 1; }",
            "task main() { float x = 1; x++; }",
            "task main() { While (true) { } }",
            "task main() { repaet (4) { Wait(1); } }",
            "task main() { if (true) Wait(1); Else Wait(2); }",
            "task main() { do Wait(1); While (false); }",
            "task main() { while (true) Break; }",
            "task main() { while (True) { } }",
            "task main() { y = 5; }",
            "task main()\n{\n    until (SENSOR_1 == 1);\n}",
            "int x;\n\n// Counts.\nvoid f() { y++; }\ntask main() { f(); }",
            "task main() { OnFwd(OUT_A; }",
            "task main() { OnFwd(OUT_A + OUT_C; }",
            "int x; task main() { x = SENSOR_1\nx++; }",
            "int x; task main() { x = Timer(0)\nx++; }",
            "int x; task main() { x = abs(Timer(0); }",
            "#define SPEED OUT_FULL\ntask main() { SetPower(OUT_A, SPEED; }",
            "",
            "// My program.",
            "int x;\n",
            "task main() { Until (SENSOR_1 > 500); }",
        )
        for (program in programs) {
            val found = diagnosticsOf(program).first()
            val fix = checkNotNull(found.fix) { "$program: $found" }
            assertTrue(diagnosticsOf(applied(program, fix)).isEmpty(), "$program: ${applied(program, fix)}")
        }
    }

    @Test
    fun `an include in angle brackets is put in quotation marks`() {
        val fix = checkNotNull(diagnosticsOf("#include <my.nqh>\ntask main() { }").single().fix)
        assertEquals("#include \"my.nqh\"\ntask main() { }", applied("#include <my.nqh>\ntask main() { }", fix))
    }

    @Test
    fun `what only firmware 2 has says so`() {
        for (call in listOf("SetEvent(1, SENSOR_1, 0);", "ClearTimer(FastTimer(0));", "SetPriority(1);")) {
            val found = diagnosticsOf("task main() { $call }", NqcOptions(FirmwareTarget.RCX)).single()
            assertTrue("firmware 2.0" in found.message, found.message)
        }
    }

    @Test
    fun `several mistakes are found at once`() {
        val source = "task main()\n{\n  x = 1;\n  OnFwd(OUT_A)\n  Wait(1 2);\n  y = 3;\n}\n"
        assertEquals(listOf(3, 4, 5, 6), diagnosticsOf(source).map { it.range?.line })
    }

    @Test
    fun `mistakes of all phases are found at once`() {
        val unread = "task main()\n{\n  y = 5;\n  onfwd(OUT_A);\n  OnFwd();\n  if (y == 5) {\n  Wait(1);\n}\n"
        assertEquals(
            listOf(3, 4, 5, 6, 9, 12, 13),
            linesOf(unread + "  other();\n}\ntask two() {\n  one();\n  Wait(1);\n"),
        )
        assertEquals(listOf(4, 5), linesOf("int p;\ntask main()\n{\n  onfwd(OUT_A);\n  OnFwd(p);\n}\n"))
    }

    @Test
    fun `what could not be read is not missing`() {
        assertEquals(listOf(1), linesOf("void step(float x) { }\ntask main()\n{\n  step(1);\n}\n"))
        assertEquals(listOf(1), linesOf("sub s { }\ntask main()\n{\n  s();\n}\n"))
        assertEquals(listOf(1), linesOf("task main {\n}\n"))
        assertEquals(listOf(1), linesOf("#include \"lost.nqh\"\ntask main()\n{\n  s();\n}\n"))
        assertEquals(listOf(1), linesOf("#include \"test.nqc\"\ntask main()\n{\n}\n"))
    }

    private fun linesOf(source: String): List<Int?> = diagnosticsOf(source).map { it.range?.line }

    @Test
    fun `directives in a skipped branch do nothing`() {
        val branches = "#if 0\n#error no\n#undef A\n#frob\n#elif A\n#else\n#warning no\n#endif\n"
        val source = "#define A 1\n${branches}task main() { Wait(A); }"
        assertTrue(diagnosticsOf(source).isEmpty(), diagnosticsOf(source).toString())
    }

    @Test
    fun `conditions compute`() {
        val conditions = listOf(
            "1 + 2 * 3 == 7",
            "(1 + 2) * 3 == 9",
            "!0",
            "~0 == -1",
            "defined(A) && !defined(B)",
            "A << 3 == 16",
            "7 % 4 == 3",
            "MISSING == 0",
            "1 ? 1 : 0",
            "(1",
            "1)",
            "",
            "1 / 0",
            "defined A",
        )
        val results = conditions.map { condition ->
            val source = "#define A 2\n#if $condition\ntask main() { }\n#endif"
            when (val result = compileNqc("x", source, messages = NqcMessages.of(Language.ENGLISH))) {
                is NqcResult.Success -> "true"
                is NqcResult.Failure -> result.diagnostics.first().code?.id
            }
        }
        val expected = List(8) { "true" } +
            listOf("condition-syntax", "condition-brackets", "condition-brackets", "condition-incomplete") +
            listOf("condition-syntax", "condition-syntax")
        assertEquals(expected, results)
    }

    @Test
    fun `a decimal number is explained`() {
        val found = diagnosticsOf("int x; task main() { x = 0.5; }").single()
        assertTrue("whole numbers" in found.message && found.fix == null, found.message)
        val time = diagnosticsOf("task main() { Wait(2.5); }").single()
        assertTrue("250" in time.message && time.fix?.replacement == "250", time.message)
        assertEquals(null, diagnosticsOf("#define HALF 0.5\ntask main() { Wait(HALF); }").single().fix)
        assertEquals(null, diagnosticsOf("task main() { Wait(1000.5); }").single().fix)
        assertEquals(null, diagnosticsOf("task main() { Wait(0.001); }").single().fix)
    }

    @Test
    fun `a variable is only declared where it gets a value`() {
        assertEquals("int y;\n\n", diagnosticsOf("task main() { y = 5; }").first().fix?.replacement)
        for (use in listOf("Wait(y);", "y[0] = 1;", "if (y == 5) Wait(1);", "OnFwd(y);")) {
            assertEquals(null, diagnosticsOf("task main() { $use }").first().fix, use)
        }
        assertEquals(null, diagnosticsOf("#define SET y = 5\ntask main() { SET; }").first().fix)
    }

    @Test
    fun `words in other capitals are only corrected if they mean nothing`() {
        val program =
            "int While; void Repeat(int n) { While = n; } task main() { While = 1; Repeat(2); Start: While++; }"
        assertEquals(emptyList(), diagnosticsOf(program))
        assertEquals("There is no variable \"If\".", message("task main() { If = 3; }").substringBefore(" Declare"))
    }

    @Test
    fun `a name alone is told by what it means`() {
        assertEquals("\"drive\" is a task. Write: start drive;", message("task main() { drive; } task drive() { }"))
        assertEquals("After \"Off\" come brackets: Off(OUT_A);", message("task main() { Off; }"))
        assertEquals("After \"f\" come brackets: f(..);", message("task main() { f; } void f(int a) { }"))
        assertEquals("There is nothing named \"OnF\". Did you mean \"OnFwd\"?", message("task main() { OnF }"))
        assertEquals(
            "There is nothing named \"xyz\". A command looks like this: OnFwd(OUT_A);",
            message("task main() { xyz; }"),
        )
    }

    @Test
    fun `a call with too few arguments shows how it is written`() {
        val calls = listOf("OnFwd()" to "OnFwd(OUT_A);", "SetSensor(SENSOR_1)" to "SetSensor(SENSOR_1, SENSOR_TOUCH);")
        for ((call, right) in calls) {
            assertTrue(message("task main() { $call; }").endsWith("Write it like this: $right"), call)
        }
        assertTrue("step(a, b);" in message("void step(int a, int b) { } task main() { step(1); }"))
    }

    private fun message(source: String): String = diagnosticsOf(source).first().message
}
