package robotran.rom

import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RomReportTest {
    private val hardware = Hardware()

    @Test
    fun `an unknown address is reported with its line and the run goes on`() {
        assertEquals("0 0x1234 1 -2 0x2000 ; nothing happens, no routine is known here ; 7", hardware.call(0x1234, 1, -2, 0x2000).text)
        assertEquals(RomOutcome.UNKNOWN_ROUTINE, hardware.log.entries.single().outcome)
        assertEquals("motor A forward 3", hardware.call(RomAddress.CONTROL_MOTOR, 0x2000, 1, 3).meaning)
    }

    @Test
    fun `a code of the wrong group is reported and has no effect`() {
        val entry = hardware.call(RomAddress.CONTROL_MOTOR, 0x3000, 1, 3)
        assertEquals("0 0x1a4e 0x3000 1 3 ; nothing happens, control motor wants a code that begins with 0x20 ; 7", entry.text)
        assertEquals(RomOutcome.WRONG_ARGUMENTS, entry.outcome)
        assertTrue(hardware.motors.states.all { it.mode == MotorMode.FLOAT })
    }

    @Test
    fun `too few arguments are reported`() {
        val entry = hardware.call(RomAddress.SET_LCD_NUMBER, 0x3001)
        assertEquals("0 0x1ff2 0x3001 ; nothing happens, set LCD number needs 3 arguments, not 1 ; 7", entry.text)
        assertEquals(RomOutcome.WRONG_ARGUMENTS, entry.outcome)
    }

    @Test
    fun `arguments too many do no harm`() {
        assertEquals(RomOutcome.DONE, hardware.call(RomAddress.REFRESH_LCD, 1, 2, 3, 4).outcome)
    }

    @Test
    fun `every routine that is known but not modelled is reported by its name`() {
        val modelled = setOf(0x14C0, 0x1946, 0x19C4, 0x1A4E, 0x1B62, 0x1E4A, 0x1FB6, 0x1FF2, 0x27AC, 0x27C8, 0x299A, 0x29F2, 0x327C, 0x3CCC)
        val others = RomTable.signatures.filter { it.address !in modelled }
        assertEquals(25, others.size)
        for (signature in others) {
            val entry = hardware.call(signature.address, 1, 2, 3, 4)
            assertEquals(RomOutcome.NOT_MODELLED, entry.outcome)
            assertEquals("nothing happens, ${signature.name} is not modelled", entry.meaning)
        }
    }

    @Test
    fun `codes and pointers are written in hexadecimal and numbers in decimal with their sign`() {
        val texts = mapOf(
            RomCall(0x1A4E, listOf(0x2000, 1, 3)) to "0x1a4e 0x2000 1 3",
            RomCall(0x1FF2, listOf(0x3001, 0xFFD6, 0x3002)) to "0x1ff2 0x3001 -42 0x3002",
            RomCall(0x327C, listOf(0x1773, 5000, 50)) to "0x327c 0x1773 5000 50",
            RomCall(0x1FB6, listOf(0x3000, 0x00F0)) to "0x1fb6 0x3000 0x00f0",
            RomCall(0x0042, listOf(0x8000, 0xFFFF, 12)) to "0x0042 0x8000 -1 12",
            RomCall(0x27C8, emptyList()) to "0x27c8",
        )
        texts.forEach { (call, text) -> assertEquals(text, RomCallText.of(call)) }
    }

    @Test
    fun `calls of the firmware have no line`() {
        hardware.rom.call(RomCall(RomAddress.REFRESH_LCD, emptyList()), sourceLine = 0)
        assertEquals("0 0x27c8 ; refresh the LCD ; firmware", hardware.log.entries.single().text)
    }
}
