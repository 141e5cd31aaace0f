package robotran.mpycompiler

import kotlin.test.Test
import kotlin.test.assertContentEquals
import kotlin.test.assertEquals
import kotlin.test.assertIs

class MpyResultTest {
    private val traceback =
        listOf("Traceback (most recent call last):", "  File \"main.py\", line 12", "SyntaxError: invalid syntax", "")

    @Test
    fun `a good run gives the file`() {
        val result = MpyResult.of(status = 0, mpy = byteArrayOf(77, 6), errors = emptyList())
        assertContentEquals(byteArrayOf(77, 6), assertIs<MpyResult.Success>(result).mpy)
    }

    @Test
    fun `a mistake gives its line and the last words`() {
        assertEquals(MpyResult.Failure(12, "SyntaxError: invalid syntax"), MpyResult.of(1, null, traceback))
        assertEquals(MpyResult.Failure(null, "MemoryError: x"), MpyResult.of(1, null, listOf("MemoryError: x")))
        assertEquals(MpyResult.Failure(null, "status 1"), MpyResult.of(1, null, emptyList()))
    }

    @Test
    fun `a run that wrote nothing is no success`() {
        assertIs<MpyResult.Failure>(MpyResult.of(0, ByteArray(0), emptyList()))
        assertIs<MpyResult.Failure>(MpyResult.of(0, null, emptyList()))
    }
}
