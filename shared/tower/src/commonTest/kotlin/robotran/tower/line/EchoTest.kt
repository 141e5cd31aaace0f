package robotran.tower.line

import robotran.tower.bytesOf
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull

class EchoTest {
    private val sent = frame(bytesOf("45 01 00 04 00 AA FF BA 00 63"))
    private val answer = bytesOf("55 FF 00 BA 45 00 FF BA 45")

    private fun assertAnswerFound(echo: ByteArray, what: String) {
        val heard = echo + answer
        val start = echoSize(heard, sent)
        assertEquals("0", findAnswer(heard, start, 0x45, 1)?.joinToString(), what)
    }

    @Test
    fun `a whole echo ends where the answer begins`() {
        assertEquals(sent.size, echoSize(sent + answer, sent))
        for (size in 0..sent.size) assertEquals(size, echoSize(sent.copyOf(size), sent))
    }

    @Test
    fun `an echo that lacks a byte or has one too many or a wrong one is followed`() {
        for (index in sent.indices) {
            val before = sent.copyOf(index)
            val behind = sent.copyOfRange(index + 1, sent.size)
            assertAnswerFound(before + behind, "byte $index is lost")
            assertAnswerFound(before + sent[index] + sent[index] + behind, "byte $index is doubled")
            assertAnswerFound(before + (sent[index].toInt() xor 0x10).toByte() + behind, "byte $index is wrong")
        }
    }

    @Test
    fun `a stray byte before the echo is left out`() {
        assertAnswerFound(byteArrayOf(0x3C) + sent, "stray byte")
    }

    @Test
    fun `data that looks like an answer is none while it is echo`() {
        val echo = frame(bytesOf("45 01 00 05 00 AA FF BA 00 BA 1D"))
        assertEquals("0", findAnswer(echo, 0, 0x45, 1)?.joinToString(), "the echo holds something like an answer")
        assertNull(findAnswer(echo, echoSize(echo, echo), 0x45, 1))
    }
}
