package robotran.tower.line

import robotran.tower.bytesOf
import robotran.tower.hexOf
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class FramingTest {
    private fun answer(heard: String, opcode: Int, size: Int) =
        findAnswer(bytesOf(heard), 0, opcode, size)?.let(::hexOf)

    @Test
    fun `a message is sent with complements and checksum`() {
        assertEquals("55 FF 00 10 EF 10 EF", hexOf(frame(bytesOf("10"))))
        assertEquals("55 FF 00 12 ED CA 35 F6 09 D2 2D", hexOf(frame(bytesOf("12 CA F6"))))
        assertEquals(11, framedSize(3))
    }

    @Test
    fun `an answer is found behind other bytes`() {
        assertEquals("00", answer("13 55 FF 00 BA 45 00 FF BA 45", 0x45, 1))
        assertEquals("", answer("55 55 FF 00 EF 10 EF 10", 0x10, 0))
    }

    @Test
    fun `an answer may lack the beginning of its header`() {
        assertEquals("00", answer("FF 00 BA 45 00 FF BA 45", 0x45, 1))
        assertEquals("00", answer("00 BA 45 00 FF BA 45", 0x45, 1))
        assertNull(answer("BA 45 00 FF BA 45", 0x45, 1))
    }

    @Test
    fun `the answer to the block before is no answer`() {
        assertNull(answer("55 FF 00 BA 45 00 FF BA 45", 0x4D, 1))
        assertEquals("01", answer("55 FF 00 BA 45 00 FF BA 45 55 FF 00 B2 4D 01 FE B3 4C", 0x4D, 1))
    }

    @Test
    fun `no damaged answer counts`() {
        val sound = bytesOf("55 FF 00 BA 45 00 FF BA 45")
        for (index in 2 until sound.size) {
            for (bit in 0..7) {
                val damaged = sound.copyOf().also { it[index] = (it[index].toInt() xor (1 shl bit)).toByte() }
                assertNull(findAnswer(damaged, 0, 0x45, 1), "bit $bit of byte $index")
            }
            assertNull(findAnswer(sound.copyOf(index), 0, 0x45, 1), "$index bytes")
        }
    }

    @Test
    fun `a new message differs from the one before it and not from others`() {
        assertEquals(0x4D, toggled(0x45, last = 0x45))
        assertEquals(0x45, toggled(0x45, last = 0x4D))
        assertEquals(0x45, toggled(0x45, last = 0x12))
    }
}
