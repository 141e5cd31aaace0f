package robotran.build.wasm

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class CalledFunctionsTest {
    private val functions = setOf(0, 1, 2, 5, 7, 8)

    @Test
    fun `functions are written as ranges, and read again`() {
        val text = CalledFunctions("ba78", functions).toString()
        assertEquals("sha256 ba78\n0-2 5 7-8\n", text.lines().drop(1).joinToString("\n"))
        val again = CalledFunctions.parse(text)
        assertEquals("ba78", again.sha256)
        assertEquals(functions, again.functions)
    }

    @Test
    fun `a file without the hash of its module is refused`() {
        assertFailsWith<IllegalArgumentException> { CalledFunctions.parse("0-2 5\n") }
    }
}
