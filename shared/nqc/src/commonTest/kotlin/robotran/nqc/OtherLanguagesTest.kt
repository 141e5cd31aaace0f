package robotran.nqc

import robotran.nqc.diagnostic.NqcDiagnosticCode
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Programs as they are written in C, in Python or in plain words, and how they are mended. */
class OtherLanguagesTest {
    @Test
    fun `a call gets its brackets`() {
        assertMended("task main() { Wait 100; }", "Wait(100);", "task main() { Wait(100); }")
        assertMended("task main() { PlayTone 440, 50; }", "PlayTone(440, 50);", "task main() { PlayTone(440, 50); }")
        assertMended("int p; task main() { SetPower OUT_A, p; }", "SetPower(OUT_A, p);")
        assertMended("task main() { turn 90; } void turn(int angle) { }", "turn(90);")
        assertMended("task main() { wait 100; }", "Did you mean \"Wait\"?", "task main() { Wait(100); }")
        val unknown = diagnosticsOf("task main() { forward 20; }").single()
        assertTrue("There is nothing named \"forward\"." in unknown.message && unknown.fix == null, unknown.message)
        assertTrue("start drive;" in diagnosticsOf("task main() { drive 5; } task drive() { }").first().message)
    }

    @Test
    fun `a semicolon or an equals sign in a definition is told there`() {
        val semicolon = "#define TIME 100;\ntask main()\n{\n    Wait(TIME);\n    Wait(TIME + 1);\n}"
        val found = diagnosticsOf(semicolon).single()
        assertEquals(1 to 17, found.range?.line to found.range?.column)
        assertMended(semicolon, "ends without a semicolon", semicolon.replace("100;", "100"))
        for (use in listOf("x = TIME + 1;", "if (x == TIME) x++;", "for (x = 0; x < TIME; x++) Wait(1);")) {
            assertMended("int x;\n#define TIME 100;\ntask main() { $use }", "ends without a semicolon")
        }
        val equals = "#define LEN = 50\ntask main()\n{\n    Wait(LEN);\n}"
        assertEquals(1, diagnosticsOf(equals).single().range?.line)
        assertMended(equals, "there is no = in a #define", equals.replace("= ", ""))
        assertEquals(emptyList(), diagnosticsOf("#define DRIVE OnFwd(OUT_A);\ntask main() { DRIVE }"))
    }

    @Test
    fun `a function in a task is moved out`() {
        val source = "task main()\n{\n    void turn() { Off(OUT_A); }\n    turn();\n    Wiat(5);\n}\n"
        val (nested, other) = diagnosticsOf(source)
        assertEquals(NqcDiagnosticCode.NESTED_UNIT to 3, nested.code to nested.range?.line)
        assertNull(nested.fix)
        assertEquals(5, other.range?.line)
        assertEquals(
            3,
            diagnosticsOf("task main()\n{\n    int turn(int a) { }\n    turn(3);\n}\n").single().range?.line,
        )
        val open = diagnosticsOf("task main()\n{\n    if (true) {\n    Wait(5);\n}\ntask two()\n{\n}\n").first()
        assertEquals(NqcDiagnosticCode.MISSING_BRACE, open.code)
    }

    @Test
    fun `a task is started without brackets`() {
        val source = "task main() { start drive(); stop drive( ); } task drive() { }"
        val once = source.replace(" stop drive( );", "")
        assertMended(once, "start drive;", once.replace("start drive()", "start drive"))
        assertTrue("stop drive;" in diagnosticsOf(source.replace("start drive();", "start drive;")).first().message)
    }

    @Test
    fun `the main task is no function`() {
        for (main in listOf("int main()", "void main()", "int main(void)", "sub main()")) {
            assertMended("$main\n{\n    OnFwd(OUT_A);\n}\n", "task main()", "task main()\n{\n    OnFwd(OUT_A);\n}\n")
        }
        val source = "int main()\n{\n    OnFwd(OUT_A);\n    return 0;\n}\n"
        assertEquals(listOf(1, 4), diagnosticsOf(source).map { it.range?.line })
        val returning = source.replace("int main()", "task main()")
        assertMended(returning, "return;", returning.replace("return 0", "return"))
    }

    @Test
    fun `a function with a type is read to its end`() {
        val source = "int speed(int a)\n{\n    return a + 1;\n}\ntask main()\n{\n    speed(3);\n}\n"
        assertEquals(listOf(1, 3), diagnosticsOf(source).map { it.range?.line })
    }

    @Test
    fun `a function of another type gives no value, whatever its type is`() {
        assertMended("float f() { } task main() { f(); }", "void f()", "void f() { } task main() { f(); }")
        assertMended("bool main() { Wait(5); }", "task main()", "task main() { Wait(5); }")
    }

    @Test
    fun `a condition before a block gets its brackets`() {
        val loop = "int x; task main() { while x < 3 { x++; } }"
        assertMended(loop, "\"(\"", loop.replace("x < 3", "(x < 3)"))
        assertMended("task main() { repeat 3 { Wait(5); } }", "\"(\"", "task main() { repeat (3) { Wait(5); } }")
        assertNull(diagnosticsOf("int x; task main() { if x == 3 Wait(5); }").single().fix)
    }

    @Test
    fun `a word before a block is no variable`() {
        val found = diagnosticsOf("task main() { forever { Wait(5); } }").single()
        assertTrue("There is nothing named \"forever\"." in found.message, found.message)
    }

    @Test
    fun `else if is two words`() {
        for (word in listOf("elseif", "elif", "elsif", "ElseIf")) {
            val source = "int i; task main() { if (i == 1) Wait(5); $word (i == 2) Wait(6); else Wait(7); }"
            assertMended(source, "Did you mean \"else if\"?", source.replace(word, "else if"))
        }
        val choices = "if (i == 1) Wait(5);\nelseif (i == 2) Wait(6);\nelif (i == 3) Wait(6);"
        val lines = "int i;\ntask main()\n{\n$choices\n}"
        assertEquals(listOf(5, 6), diagnosticsOf(lines).map { it.range?.line })
    }

    @Test
    fun `a command that was begun is completed, and nothing is guessed`() {
        assertMended("task main() { Of(OUT_A + OUT_C); }", "\"Off\"", "task main() { Off(OUT_A + OUT_C); }")
        assertNull(diagnosticsOf("task main() { OnF; }").first().fix)
        val ways = "int way1, way2;\ntask main() { way3 = 5; way1 = way2; Wait(way1 + way3); }"
        assertTrue("int way3;" in diagnosticsOf(ways).first().message)
    }

    @Test
    fun `a constant is a define`() {
        val source = "const int X = 5;\ntask main()\n{\n    Wait(X);\n}\n"
        assertMended(source, "Write: #define X 5", source.replace("const int X = 5;", "#define X 5"))
        assertMended(source.replace("= 5", "= 5 + 2"), "Write: #define X (5 + 2)")
        assertMended(source.replace("const int", "int const"), "#define X 5")
        assertMended(source.replace("const int", "const"), "#define X 5")
        val within = "task main()\n{\n    const int X = 5;\n    Wait(X);\n}\n"
        assertMended(within, "#define X 5", within.replace("const int X = 5;", "#define X 5"))
        assertMended("task main() { const int X = 5; Wait(X); }", "int X", "task main() { int X = 5; Wait(X); }")
        val two = "const int A = 1, B = 2;\ntask main() { Wait(A + B); }"
        assertMended(two, "int A", two.replace("const int", "int"))
        assertEquals(emptyList(), diagnosticsOf("void f(const int x) { Wait(x); }\ntask main() { f(5); }"))
    }

    @Test
    fun `a word before a declaration that NQC does not have is left out`() {
        assertMended("static int x = 5; task main() { Wait(x); }", "static", "int x = 5; task main() { Wait(x); }")
        assertMended("unsigned int x = 5; task main() { Wait(x); }", "unsigned")
        assertMended("public task main() { Wait(5); }", "public", "task main() { Wait(5); }")
        val function = "public static void go() { Wait(5); }\ntask main() { go(); }"
        assertEquals(listOf(1), diagnosticsOf(function).map { it.range?.line }.distinct())
    }

    @Test
    fun `a task has no parameters`() {
        val source = "task main() { start drive; } task drive(void) { Wait(5); }"
        assertMended(source, "task drive()", source.replace("void", ""))
        val used = diagnosticsOf("task main() { start drive; }\ntask drive(int x) { Wait(x); }").single()
        assertTrue("global variable" in used.message && used.range?.line == 2, used.message)
        val given = diagnosticsOf("task main() { start drive(5); }\ntask drive(int x) { Wait(x); }")
        assertEquals(listOf(1, 2), given.map { it.range?.line })
        assertTrue("start drive;" in given.first().message && given.first().fix == null, "5 would be lost")
    }

    @Test
    fun `a task is started with the words of NQC`() {
        for (call in listOf(
            "StartTask(drive)",
            "StartTask(drive())",
            "StartTask drive",
            "start(drive)",
            "run(drive)",
        )) {
            val source = "task main() { $call; } task drive() { Wait(5); }"
            assertMended(source, "start drive;", source.replace(call, "start drive"))
        }
        val stopped = "task main() { start drive; StopTask(drive); } task drive() { Wait(5); }"
        assertMended(stopped, "stop drive;", stopped.replace("StopTask(drive)", "stop drive"))
        assertEquals(emptyList(), diagnosticsOf("void run(int x) { Wait(x); }\ntask main() { run(5); }"))
    }

    @Test
    fun `a sensor has the name that NQC gives it now`() {
        val setting = "task main() { SetSensor(IN_1, SENSOR_TOUCH); until(SENSOR_1 == 1); }"
        assertMended(setting, "\"SENSOR_1\"", setting.replace("IN_1", "SENSOR_1"))
        for (call in listOf("Sensor(IN_2)", "Sensor(SENSOR_2)", "sensor(2)", "Sensor(S2)")) {
            val source = "task main() { SetSensor(SENSOR_2, SENSOR_TOUCH); if ($call == 1) Wait(5); }"
            assertMended(source, "its name alone: SENSOR_2", source.replace(call, "SENSOR_2"))
        }
    }

    @Test
    fun `what the brick has no more of is told, not taken for another one`() {
        val others = mapOf(
            "OnFwd(OUT_D)" to "OUT_A, OUT_B, OUT_C",
            "OnFwd(OUT_AD)" to "OUT_AB, OUT_AC",
            "SetSensor(SENSOR_4, SENSOR_TOUCH)" to "SENSOR_1, SENSOR_2, SENSOR_3",
            "SetSensor(IN_4, SENSOR_TOUCH)" to "SENSOR_1, SENSOR_2, SENSOR_3",
            "ClearTimer(T5)" to "T1, T2, T3, T4",
        )
        for ((command, names) in others) {
            val found = diagnosticsOf("task main() { $command; }").single()
            assertTrue("There are: $names" in found.message, found.message)
            assertNull(found.fix, command)
        }
        assertTrue("int way2;" in diagnosticsOf("task main() { int way1; way1 = 1; way2 = way1; }").single().message)
    }

    /** The only mistake of [source] says [advice], and its fix leaves none. */
    private fun assertMended(source: String, advice: String, expected: String? = null) {
        val found = diagnosticsOf(source).single()
        assertTrue(advice in found.message, found.message)
        val mended = applied(source, checkNotNull(found.fix) { "$source: $found" })
        if (expected != null) assertEquals(expected, mended)
        assertEquals(emptyList(), diagnosticsOf(mended), mended)
    }
}
