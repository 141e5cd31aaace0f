package robotran.nqc

import robotran.legofirmware.image.FirmwareTarget
import robotran.nqc.diagnostic.NqcDiagnosticCode
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Code that no vector has, from the rules of the reference; and where ours is better than that of the original. */
class CodeTest {
    @Test
    fun `a random number is no operand of a test`() = assertEquals(
        "14 2f 04 06 00 85 42 00 03 00 2f 02 50",
        codeOf("task main() { if (Random(6) > 3) StopAllTasks(); }"),
    )

    @Test
    fun `the first firmware moves operands to variables`() {
        val source = "int x; task main() { x = x + SENSOR_1; }"
        assertEquals("14 01 09 00 00 24 00 00 01 00", codeOf(source, FirmwareTarget.RCX))
        assertEquals("24 00 09 00 00", codeOf(source))
    }

    @Test
    fun `a condition that uses its target computes first`() = assertEquals(
        "85 82 00 00 00 00 08 14 00 02 00 00 27 06 14 00 02 01 00",
        codeOf("int x; task main() { x = !(x == 0); }"),
    )

    @Test
    fun `leaving a guard ends it`() {
        val code = codeOf("task main() { while (true) { acquire (1) { break; } } }")
        assertEquals("73 01 06 00 a0 27 04 a0 27 89", code)
    }

    @Test
    fun `a dead branch with a label stays`() {
        val code = codeOf("int x; task main() { goto in; if (false) { in: x = 1; } }")
        assertEquals("27 03 27 06 14 00 02 01 00", code)
    }

    @Test
    fun `an element of an array that is used on the right is computed first`() {
        // The original assigns 5 before it reads the element.
        val code = codeOf("int a[2]; task main() { a[1] = 5 - a[1]; }")
        assertEquals("14 2f 02 05 00 34 2f 00 01 00 14 01 00 2f 00", code)
    }

    @Test
    fun `a pointer to a variable changes that variable`() {
        val code = codeOf("int x, y; void set(int *p) { *p = 7; } task main() { set(&y); }")
        assertEquals("14 01 02 07 00", code)
    }

    @Test
    fun `programs with many elements of arrays fit all the same`() {
        val sums = "x = (a[i] + 1) + (a[i] + 2);".repeat(40)
        val source = "int a[20], i, x; task main() { $sums }"
        assertTrue(codeOf(source).isNotEmpty())
    }

    @Test
    fun `a condition that can never be true is not dropped with what follows`() {
        val code = codeOf("int x, y; task main() { while (x < -32768 || y == 1); }")
        assertEquals("95 c2 00 01 00 01 fa ff", code)
    }

    @Test
    fun `an element of an array that is changed is computed first`() {
        val main = "int a[3], g; task main() { %s }"
        assertEquals(codeOf(main.replace("%s", "a[2] = a[2] ^ 255;")), codeOf(main.replace("%s", "a[2] ^= 255;")))
        assertEquals(codeOf(main.replace("%s", "a[1] = a[1] % g;")), codeOf(main.replace("%s", "a[1] %= g;")))
    }

    @Test
    fun `a condition beyond the largest number is never true`() {
        assertEquals(
            "14 00 02 02 00",
            codeOf("int x; task main() { if (x > 32767 && x == 3) x = 1; x = 2; }").takeLast(14),
        )
    }

    @Test
    fun `a source of constants is a constant`() {
        assertEquals(
            codeOf("int x; task main() { x = 1; }"),
            codeOf("int x; task main() { if (@0x20005) x = 1; else x = 2; }"),
        )
        assertEquals(
            codeOf("int x; task main() { x = 2; }"),
            codeOf("int x; task main() { if (@0x20000) x = 1; else x = 2; }"),
        )
        assertEquals(codeOf("int x; task main() { x = 8; }"), codeOf("int x; task main() { x = @0x20005 + 3; }"))
    }

    @Test
    fun `a pointer that nothing uses is no mistake for the first firmware`() {
        val source = "int *p, x; task main() { x = 1; }"
        assertEquals(codeOf("int p, x; task main() { x = 1; }", FirmwareTarget.RCX), codeOf(source, FirmwareTarget.RCX))
    }

    @Test
    fun `constants that are too large do not matter in code that never runs`() {
        val source = "int x; task main() { if (false) { PlayTone(70000, 5); x = 100000 + x; } x = 1; }"
        assertEquals(codeOf("int x; task main() { x = 1; }"), codeOf(source))
    }

    @Test
    fun `symbols name chunks and variables`() {
        val image = programOf("int g; sub s() { } task other() { } task main() { int l; l = g; }").image
        val symbols = image.symbols.map { "${it.kind} ${it.number} ${it.name}" }
        assertEquals(listOf("SUB 0 s", "TASK 0 main", "TASK 1 other", "VARIABLE 0 g", "VARIABLE 47 l"), symbols)
    }

    @Test
    fun `included files belong to the program`() {
        val files = mapOf("lib.nqh" to "#define FAST 7\nvoid go() { SetPower(OUT_A, FAST); }")
        val source = "#pragma noinit\n#include \"lib.nqh\"\ntask main() { go(); }"
        val program = programOf(source, NqcOptions(files = files))
        assertEquals("13 01 02 07", program.image.chunks.single().code.toString())
        assertEquals("lib.nqh", program.lines.values.single().single().range.file)
        assertEquals(2, program.lines.values.single().single().range?.line)
    }

    @Test
    fun `a mistake in an included file names the file`() {
        val files = mapOf("lib.nqh" to "\nint x\n")
        val found = diagnosticsOf("#include \"lib.nqh\"\ntask main() { }", NqcOptions(files = files)).single()
        assertEquals(NqcDiagnosticCode.MISSING_SEMICOLON, found.code)
        assertEquals("lib.nqh" to 2, found.file to found.range?.line)
    }

    @Test
    fun `programs of NQC 1 3 compile`() {
        val source = "task main() { Sensor(IN_1, IN_SWITCH); Fwd(OUT_A + OUT_C, 5); wait(IN_1 == 1); Sleep(50); }"
        val code = programOf(source, NqcOptions(isOld = true)).image.chunks.single().code.toString()
        val expected = "32 00 01 42 00 20 e1 85 21 85 13 05 02 05 95 82 09 01 00 00 fa ff 43 02 32 00"
        assertEquals(expected, code)
    }
}
