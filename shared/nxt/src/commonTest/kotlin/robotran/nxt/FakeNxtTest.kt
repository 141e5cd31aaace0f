package robotran.nxt

import robotran.nxt.program.NxtCall
import robotran.nxt.program.NxtNative
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class FakeNxtTest {
    private val nxt = FakeNxt()

    @Test
    fun `motors follow their power at once`() {
        nxt.call(NxtCall.controlMotor(0, 50, brakes = true), 3)
        nxt.call(NxtCall.controlMotor(2, -36, brakes = true), 4)
        nxt.advance(1_000)
        assertEquals(500, nxt.tachoCount(0))
        assertEquals(-360, nxt.tachoCount(2))
        assertEquals(listOf(3, 4), nxt.lines)
    }

    @Test
    fun `its regulators bring a motor where it should be`() {
        nxt.call(NxtCall.regulate(1, 360f, 6_000, 180, hold = true), 1)
        assertTrue(nxt.regulator(1).isMoving)
        nxt.advance(1_500)
        assertFalse(nxt.regulator(1).isMoving)
        assertTrue(nxt.tachoCount(1) in 178..182, "${nxt.tachoCount(1)} degrees")
    }

    @Test
    fun `it shows what was drawn and keeps the calls`() {
        nxt.call(NxtCall.drawString("Hello", 0, 0), 1)
        assertEquals(listOf("Hello"), nxt.display.texts)
        assertEquals(listOf(NxtNative.DRAW_STRING), nxt.calls.map { it.native })
    }

    @Test
    fun `sensors answer what the test wants`() {
        nxt.analog[0] = 300
        nxt.answers[3] = { byteArrayOf(30) }
        assertEquals(300, nxt.analog(0))
        nxt.call(NxtCall(NxtNative.I2C_START, intArrayOf(3, 2, 1), bytes = byteArrayOf(0x42)), 1)
        val into = ByteArray(1)
        assertEquals(1, nxt.i2cComplete(3, into))
        assertEquals(30, into[0].toInt())
    }
}
