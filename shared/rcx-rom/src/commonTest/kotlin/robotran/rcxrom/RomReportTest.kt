package robotran.rcxrom

import robotran.brick.controls.MotorMode
import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.call.RomCallText
import robotran.rcxrom.call.RomTable
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

class RomReportTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `an unknown address is reported with its line and the run goes on`() {
        assertEquals(
            "0 0x1234 1 -2 0x2000 ; nothing happens, no routine is known here ; 7",
            hardware.call(0x1234, 1, -2, 0x2000).text,
        )
        assertEquals(CallOutcome.UNKNOWN_ROUTINE, hardware.log.entries.single().outcome)
        assertEquals("motor A forward 3", hardware.call(RomAddress.CONTROL_MOTOR, 0x2000, 1, 3).meaning)
    }

    @Test
    fun `a code of the wrong group is reported and has no effect`() {
        val entry = hardware.call(RomAddress.CONTROL_MOTOR, 0x3000, 1, 3)
        assertEquals(
            "0 0x1a4e 0x3000 1 3 ; nothing happens, control motor wants a code that begins with 0x20 ; 7",
            entry.text,
        )
        assertEquals(CallOutcome.WRONG_ARGUMENTS, entry.outcome)
        assertTrue(hardware.motors.states.all { it.mode == MotorMode.FLOAT })
    }

    @Test
    fun `too few arguments are reported`() {
        val entry = hardware.call(RomAddress.SET_LCD_NUMBER, 0x3001)
        assertEquals("0 0x1ff2 0x3001 ; nothing happens, set LCD number needs 3 arguments, not 1 ; 7", entry.text)
        assertEquals(CallOutcome.WRONG_ARGUMENTS, entry.outcome)
    }

    @Test
    fun `arguments too many do no harm`() {
        assertEquals(CallOutcome.DONE, hardware.call(RomAddress.REFRESH_LCD, 1, 2, 3, 4).outcome)
    }

    @Test
    fun `a routine that is not modelled is reported by its name and the reason`() {
        val entry = hardware.call(0x36BA)
        assertEquals(
            "nothing happens, handle timer tick is not modelled: the brick does this by itself every millisecond",
            entry.meaning,
        )
        assertEquals(CallOutcome.NOT_MODELLED, entry.outcome)
        assertEquals(listOf(0x36BA), RomTable.signatures.filter { it.gap != null }.map { it.address })
    }

    @Test
    fun `every other routine is there`() {
        for (signature in RomTable.signatures - RomTable.signatures.filter { it.gap != null }.toSet()) {
            val entry = Hardware(messages = BrickMessages.of(Language.ENGLISH)).call(
                signature.address,
                (signature.codeGroup ?: 0x90) shl 8,
                0x9000,
                0x9010,
                4,
            )
            assertTrue(
                entry.outcome == CallOutcome.DONE || entry.outcome == CallOutcome.WRONG_ARGUMENTS,
                signature.name,
            )
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
