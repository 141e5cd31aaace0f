package robotran.rcxrom

import robotran.brick.controls.BrickButton
import robotran.brick.kind.BrickKind
import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.Battery
import kotlin.test.Test
import kotlin.test.assertEquals

class ButtonRoutineTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    @Test
    fun `each button that is held down has its bit`() {
        val combinations = mapOf(
            emptySet<BrickButton>() to 0,
            setOf(BrickButton.RUN) to 1,
            setOf(BrickButton.VIEW) to 2,
            setOf(BrickButton.PRGM) to 4,
            setOf(BrickButton.RUN, BrickButton.PRGM) to 5,
            setOf(BrickButton.RUN, BrickButton.VIEW, BrickButton.PRGM, BrickButton.ON_OFF) to 7,
        )
        for ((held, bits) in combinations) {
            BrickKind.RCX.buttons.forEach { hardware.buttons.hold(it, it in held) }
            hardware.memory.writeShort(RESULT, -1)
            hardware.call(RomAddress.READ_BUTTONS, 0x3000, RESULT)
            assertEquals(bits, hardware.memory.readShort(RESULT))
        }
    }

    @Test
    fun `the log names the buttons that are held down`() {
        assertEquals(
            "0 0x1fb6 0x3000 0x9000 ; buttons held down: none ; 7",
            hardware.call(RomAddress.READ_BUTTONS, 0x3000, RESULT).text,
        )
        hardware.buttons.hold(BrickButton.RUN, down = true)
        hardware.buttons.hold(BrickButton.VIEW, down = true)
        assertEquals("buttons held down: Run, View", hardware.call(RomAddress.READ_BUTTONS, 0x3000, RESULT).meaning)
    }

    @Test
    fun `the On-Off key reads 0 while it is held down`() {
        assertEquals(
            "the On-Off key is up",
            hardware.call(RomAddress.READ_POWER_STATUS, RomCode.ON_OFF_KEY, RESULT).meaning,
        )
        assertEquals(2, hardware.memory.readShort(RESULT))
        hardware.buttons.hold(BrickButton.ON_OFF, down = true)
        assertEquals(
            "the On-Off key is held down",
            hardware.call(RomAddress.READ_POWER_STATUS, RomCode.ON_OFF_KEY, RESULT).meaning,
        )
        assertEquals(0, hardware.memory.readShort(RESULT))
    }

    @Test
    fun `the battery is full`() {
        val entry = hardware.call(RomAddress.READ_POWER_STATUS, RomCode.BATTERY, RESULT)
        assertEquals("0 0x29f2 0x4001 0x9000 ; the battery measures 320 ; 7", entry.text)
        assertEquals(320, hardware.memory.readShort(RESULT))
    }

    @Test
    fun `other power codes are reported and write nothing`() {
        hardware.memory.writeShort(RESULT, 1234)
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hardware.call(RomAddress.READ_POWER_STATUS, 0x4002, RESULT).outcome)
        assertEquals(1234, hardware.memory.readShort(RESULT))
    }

    @Test
    fun `a result at the end of memory wraps around into the ROM which stays as it is`() {
        val before = hardware.memory.readByte(0x0000)
        hardware.memory.writeByte(0xFFFF, 0x55)
        hardware.call(RomAddress.READ_BUTTONS, 0x3000, 0xFFFF)
        assertEquals(0, hardware.memory.readByte(0xFFFF))
        assertEquals(before, hardware.memory.readByte(0x0000))
    }

    @Test
    fun `the pins of the buttons can be seen in memory`() {
        val pins = { hardware.memory.readByte(0xFFB7) and 0x06 to (hardware.memory.readByte(0xFFBE) and 0xC0) }
        assertEquals(0x02 to 0x00, pins())
        BrickKind.RCX.buttons.forEach { hardware.buttons.hold(it, down = true) }
        assertEquals(0x04 to 0xC0, pins())
    }

    @Test
    fun `the battery measures what the batteries give`() {
        hardware.measureBattery(250)
        hardware.call(RomAddress.READ_POWER_STATUS, RomCode.BATTERY, RESULT)
        assertEquals(250, hardware.memory.readShort(RESULT))
        assertEquals(7049, Battery.millivolts(250))
        assertEquals(250, Battery.rawOf(7049))
        assertEquals(320, Battery.rawOf(9000))
        assertEquals(1023, Battery.rawOf(100_000))
        assertEquals(0, Battery.rawOf(-5))
    }

    @Test
    fun `another code than that of the buttons is reported`() {
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hardware.call(RomAddress.READ_BUTTONS, 0x3001, RESULT).outcome)
    }
}
