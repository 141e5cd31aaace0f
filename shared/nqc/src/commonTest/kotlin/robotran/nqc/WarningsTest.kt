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

    private fun check(source: String, code: NqcDiagnosticCode) {
        val found = diagnosticsOf(source)
        assertEquals(listOf(code), found.map { it.code }.distinct(), "$source $found")
    }
}
