package robotran.hublink.output

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

class OutputReaderTest {
    private val python = listOf(
        "from pybricks.pupdevices import Motor",
        "left = Motor(Port.A, Direction.COUNTERCLOCKWISE)",
        "pen = Motor(Port.C)",
        "pair = [Port.A, Port.B]",
        "print(1 // 0)",
    )
    private val map = SourceMap("prog.py", python, mapOf(3 to 1, 5 to 7))

    private fun read(text: String, pieces: Int = 19, map: SourceMap? = this.map): HubConsole {
        val reader = OutputReader(map)
        text.encodeToByteArray().toList().chunked(pieces).forEach { reader.add(it.toByteArray()) }
        return reader.console
    }

    private fun traceback(vararg places: Pair<Int, String>, error: String) = "Traceback (most recent call last):\r\n" +
        places.joinToString("") { "  File \"prog.py\", line ${it.first}, in ${it.second}\r\n" } + "$error\r\n"

    @Test
    fun `letters that are cut in two come out whole`() {
        val text = "größe µ ✓ 🤖\r\nübrig"
        for (size in 1..text.encodeToByteArray().size) {
            val console = read(text, size)
            assertEquals(listOf("größe µ ✓ 🤖"), console.lines, "$size bytes at a time")
            assertEquals("übrig", console.unfinished, "$size bytes at a time")
        }
    }

    @Test
    fun `what is no UTF-8 does not stop what follows`() {
        val reader = OutputReader(null)
        reader.add(byteArrayOf(-1, -61, 65, -128, 13, 10))
        reader.add("gut\r\n".encodeToByteArray())
        assertEquals("gut", reader.console.lines.last())
        assertTrue("A" in reader.console.lines.first())
    }

    @Test
    fun `an error belongs to the innermost line of the pupil`() {
        val text = traceback(5 to "<module>", 2 to "half", error = "ZeroDivisionError: divide by zero")
        val error = read("before\r\n$text").error
        assertEquals(
            ProgramError(ProgramErrorKind.DIVISION_BY_ZERO, 7, "A", "ZeroDivisionError: divide by zero"),
            error,
        )
    }

    @Test
    fun `a missing motor is told with its port`() {
        val text = traceback(3 to "<module>", error = "OSError: [Errno 19] ENODEV:") +
            "\r\nA motor or sensor is not connected to the specified port.\r\n"
        val error = read(text).error
        assertEquals(ProgramErrorKind.MISSING_DEVICE, error?.kind)
        assertEquals("C", error?.port)
        assertEquals(1, error?.line)
    }

    @Test
    fun `a line that names two ports or none tells no port`() {
        assertNull(map.portOf(4))
        assertNull(map.portOf(5))
        assertNull(map.portOf(50))
    }

    @Test
    fun `kinds of errors are told apart`() {
        val kinds = mapOf(
            "OverflowError: long int not supported in this build" to ProgramErrorKind.NUMBER_TOO_LARGE,
            "IndexError: list index out of range" to ProgramErrorKind.OUTSIDE_LIST,
            "MemoryError: memory allocation failed" to ProgramErrorKind.NO_MEMORY,
            "OSError: [Errno 1] EPERM" to ProgramErrorKind.OTHER,
            "ImportError: no module named 'shapes'" to ProgramErrorKind.OTHER,
        )
        for ((line, kind) in kinds) assertEquals(kind, read(traceback(5 to "<module>", error = line)).error?.kind, line)
    }

    @Test
    fun `without a map an error has no line`() {
        assertNull(read(traceback(5 to "<module>", error = "OverflowError: x"), map = null).error?.line)
    }

    @Test
    fun `a stop is no error`() {
        val console = read("The program was stopped (SystemExit).\r\n")
        assertTrue(console.wasStopped)
        assertNull(console.error)
    }

    @Test
    fun `marks tell the running line and are no text`() {
        val console = read("one\r\n${OutputReader.MARK}3\r\ntwo\r\n${OutputReader.MARK}4\r\n${OutputReader.MARK}x\r\n")
        assertEquals(listOf("one", "two"), console.lines)
        assertEquals(1, console.runningLine)
        assertEquals("", read("${OutputReader.MARK}3").unfinished)
    }

    @Test
    fun `output without end stays small`() {
        val console = read("x".repeat(5_000) + "\r\n" + "y\r\n".repeat(3_000))
        assertEquals(HubConsole.MAX_LINES, console.lines.size)
        assertTrue(read("z".repeat(5_000)).lines.all { it.length <= HubConsole.MAX_LINE })
        assertTrue(read("z".repeat(5_000)).unfinished.length <= HubConsole.MAX_LINE)
    }
}
