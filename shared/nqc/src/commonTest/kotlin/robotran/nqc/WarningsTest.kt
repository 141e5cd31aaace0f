package robotran.nqc

import robotran.nqc.diagnostic.NqcDiagnosticCode
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class WarningsTest {
    @Test
    fun `warnings that the original compiler lacks`() {
        check("int x; task main() { x = x / 0; }", NqcDiagnosticCode.DIVIDED_BY_ZERO)
        check("int x; task main() { x = x % 0; }", NqcDiagnosticCode.DIVIDED_BY_ZERO)
        check("int x; task main() { x = 3 / 0; }", NqcDiagnosticCode.CONSTANT_DIVIDED_BY_ZERO)
        check("int x; task main() { x = 40000 * 2; }", NqcDiagnosticCode.NUMBER_CUT)
        check("int a[3]; task main() { a[3] = 1; }", NqcDiagnosticCode.INDEX_OUTSIDE)
        check("int x; task main() { x == 3; }", NqcDiagnosticCode.NO_EFFECT)
        check("task main() { OnFwd(8); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { SetPower(OUT_A, 8); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { PlaySound(6); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { PlayTone(440, 300); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { SendMessage(300); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { Wait(-1); }", NqcDiagnosticCode.ARGUMENT_RANGE)
        check("task main() { } task other() { }", NqcDiagnosticCode.TASK_NEVER_STARTED)
        check("int x; task main() { for (x = 0; x < 3; x++); { Wait(1); } }", NqcDiagnosticCode.EMPTY_BODY)
        check("int x; task main() { ${"x = x + 1;\n".repeat(1300)} }", NqcDiagnosticCode.MEMORY_FULL)
    }

    @Test
    fun `a line that only looks as if it belonged to a statement is told`() {
        val bodies = listOf(
            "if (x == 1)\n    x = 2;\n    x = 3;\n",
            "while (x < 3)\n    x++;\n    Wait(1);\n",
            "repeat (2)\n\n    Wait(1);\n    // twice\n    x++;\n",
            "for (x = 0; x < 3; x++)\n    Wait(1);\n    Wait(2);\n",
            "if (x == 1)\n    x = 2;\nelse\n    x = 3;\n    Wait(1);\n",
            "if (x == 1) {\n    x = 2;\n} else if (x == 2)\n    x = 3;\n    Wait(1);\n",
        )
        for (body in bodies) {
            val found = diagnosticsOf("int x;\ntask main()\n{\n$body}\n").single()
            assertEquals(NqcDiagnosticCode.MISLEADING_INDENT, found.code, body)
            assertEquals(2 + body.lines().size, found.range?.line, body)
        }
    }

    @Test
    fun `lines that belong together are not told`() {
        val bodies = listOf(
            "if (x == 1)\n    x = 2;\nx = 3;\n",
            "if (x == 1)\nx = 2;\nx = 3;\n",
            "if (x == 1) x = 2;\n    x = 3;\n",
            "if (x == 1)\n{\n    x = 2;\n}\nx = 3;\n",
            "if (x == 1)\n    x = 2;\n    else x = 3;\n",
            "while (true)\n    if (x == 1)\n        x = 2;\n    else\n        x = 3;\n",
            "do\n    if (x == 1)\n    x = 2;\n    while (x < 2);\n",
            "if (x == 1)\n    x = 2; x = 3;\n",
            "switch (x)\n{\n    case 1:\n    if (x == 1)\n        x = 2;\n    case 2:\n        x = 3;\n}\n",
        )
        for (body in bodies) assertEquals(emptyList(), diagnosticsOf("int x;\ntask main()\n{\n$body}\n"), body)
    }

    @Test
    fun `a sensor of which nothing says what it is`() {
        val uses =
            listOf("until (SENSOR_2 == 1);", "while (0 == SENSOR_2);", "if (SENSOR_2 < 40) Wait(1);", "f(SENSOR_2);")
        val function = "void f(__sensor s) { until (s == 1); } "
        for (use in uses) {
            val found = diagnosticsOf("${function}task main() { $use }").single()
            assertEquals(NqcDiagnosticCode.SENSOR_NOT_SET, found.code, use)
            assertTrue("SetSensor(SENSOR_2" in found.message, found.message)
            for (call in listOf("SetSensor(SENSOR_2, SENSOR_TOUCH)", "SetSensorMode(SENSOR_2, SENSOR_MODE_BOOL)")) {
                assertEquals(emptyList(), diagnosticsOf("${function}task main() { $call; $use }"), use)
            }
            assertEquals(1, diagnosticsOf("${function}task main() { SetSensor(SENSOR_1, SENSOR_TOUCH); $use }").size)
        }
        for (use in listOf("until (SENSOR_2 > 500);", "SetUserDisplay(SENSOR_2, 0);", "until (Timer(0) == 1);")) {
            assertEquals(emptyList(), diagnosticsOf("task main() { $use }"), use)
        }
        for (set in listOf("asm { 0x32, 1, 1 };", "asm { 0x10, 0x32, 1, 1 };", "SensorType(1) = 1;")) {
            assertEquals(emptyList(), diagnosticsOf("task main() { $set until (SENSOR_2 == 1); }"), set)
        }
        val old = NqcOptions(isOld = true)
        assertEquals(emptyList(), diagnosticsOf("task main() { wait(IN_2 == 1); }", old))
    }

    @Test
    fun `programs of the original compiler have no false alarms`() {
        val layout = setOf(NqcDiagnosticCode.MISLEADING_INDENT, NqcDiagnosticCode.SENSOR_NOT_SET)
        for ((name, source) in Vectors.programs) {
            val found = diagnosticsOf(source).filter { it.code in layout }.map { it.range?.line to it.code }
            // It waits for a sensor that nobody has set up: on a brick, for ever.
            val right = if (name == "14-acquire") listOf(22 to NqcDiagnosticCode.SENSOR_NOT_SET) else emptyList()
            assertEquals(right, found, name)
        }
    }

    private fun check(source: String, code: NqcDiagnosticCode) {
        val found = diagnosticsOf(source)
        assertEquals(listOf(code), found.map { it.code }.distinct(), "$source $found")
    }
}
