package robotran.rcxrom

import robotran.brick.log.CallOutcome
import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.log.romCalls
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorMode
import robotran.rcxrom.sensors.SensorRequest
import robotran.rcxrom.sensors.SensorState
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

class SensorTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    private fun measure(port: Int, raw: Int): List<Int> {
        hardware.sensors.measure(port, raw)
        hardware.tick(3)
        return SensorRequest.entries.map { hardware.rom.readSensor(port, it) }
    }

    @Test
    fun `an open port measures the most and means 0 percent and false`() {
        assertEquals(listOf(1023, 0, 0), SensorRequest.entries.map { hardware.rom.readSensor(1, it) })
    }

    @Test
    fun `percent are the ROM's own with its quirk at 391`() {
        val percent = mapOf(
            0 to 100,
            390 to 100,
            391 to 101,
            392 to 101,
            400 to 99,
            500 to 83,
            690 to 53,
            800 to 35,
            900 to 19,
            1023 to 0,
        )
        for ((raw, value) in percent) assertEquals(value, measure(1, raw)[1], "raw $raw")
    }

    @Test
    fun `between 460 and 563 true and false stay as they were`() {
        val steps = listOf(500 to 0, 460 to 0, 459 to 1, 500 to 1, 563 to 1, 564 to 0, 500 to 0)
        for ((raw, value) in steps) assertEquals(value, measure(0, raw)[2], "raw $raw")
    }

    @Test
    fun `a slope tells jumps`() {
        hardware.rom.setSensorTypeAndMode(0, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN + 10)
        val steps = listOf(1014 to 0, 700 to 1, 705 to 1, 711 to 1, 722 to 0, 715 to 0, 705 to 1, 9 to 1)
        for ((raw, value) in steps) assertEquals(value, measure(0, raw)[2], "raw $raw")
    }

    @Test
    fun `the mode decides what the value is`() {
        hardware.rom.setSensorTypeAndMode(2, SensorCode.TYPE_TOUCH, SensorCode.MODE_BOOLEAN)
        assertEquals(listOf(300, 1, 1), measure(2, 300))
        hardware.rom.setSensorTypeAndMode(2, SensorCode.TYPE_LIGHT, SensorCode.MODE_RAW)
        assertEquals(listOf(700, 700, 0), measure(2, 700))
    }

    @Test
    fun `a change is seen at the next reading, every third millisecond`() {
        hardware.tick(1)
        hardware.sensors.measure(0, 300)
        hardware.tick(1)
        assertEquals(1023, hardware.rom.readSensor(0, SensorRequest.RAW))
        hardware.tick(1)
        assertEquals(300, hardware.rom.readSensor(0, SensorRequest.RAW))
    }

    @Test
    fun `no port measures more than its converter can`() {
        assertEquals(1023, measure(0, 5000)[0])
        assertEquals(0, measure(0, -5)[0])
    }

    @Test
    fun `ports are switched on and off`() {
        assertEquals("0 0x1946 0x1001 ; sensor 2 active ; 7", hardware.call(RomAddress.ACTIVATE_SENSOR, 0x1001).text)
        assertTrue(hardware.sensors.isActive(1))
        assertFalse(hardware.sensors.isActive(0))
        assertEquals(2, hardware.memory.readByte(0xEFD5))
        assertEquals("sensor 2 passive", hardware.call(RomAddress.PASSIVATE_SENSOR, 0x1001).meaning)
        assertFalse(hardware.sensors.isActive(1))
        assertEquals(CallOutcome.WRONG_ARGUMENTS, hardware.call(RomAddress.ACTIVATE_SENSOR, 0x1003).outcome)
    }

    @Test
    fun `the routine reads into the place it is given`() {
        hardware.sensors.measure(1, 500)
        hardware.memory.writeByte(RESULT + 1, SensorCode.MODE_PERCENT)
        assertEquals("read sensor 2", hardware.call(RomAddress.READ_SENSOR, 0x1001, RESULT).meaning)
        assertEquals(500, hardware.memory.readShort(RESULT + 2))
        assertEquals(83, hardware.memory.readShort(RESULT + 4))
    }

    @Test
    fun `a brick's sensors are measured from outside`() {
        val brick = RcxBrick(emptyList(), messages = BrickMessages.of(Language.ENGLISH))
        brick.setRawSensorValue(0, 200)
        repeat(3) { brick.tick() }
        assertFalse(brick.sensorIsActive(0))
        assertEquals(emptyList(), brick.log.entries.romCalls().filter { it.call.address == RomAddress.READ_SENSOR })
    }

    @Test
    fun `a program can set each field of the table`() {
        hardware.rom.setSensorValue(1, 0x40, SensorField.MODE)
        hardware.rom.setSensorValue(1, 4, SensorField.TYPE)
        hardware.rom.setSensorValue(1, -7, SensorField.VALUE)
        hardware.rom.setSensorValue(1, 1, SensorField.BOOLEAN)
        assertEquals(listOf(4, 0x40), listOf(0x8018, 0x8019).map(hardware.memory::readByte))
        assertEquals(
            SensorState(2, SensorMode.EDGE, 1023, -7, boolean = true, active = false),
            hardware.sensors.states[1],
        )
    }

    @Test
    fun `the raw value is what the converter has in its register`() {
        hardware.sensors.measure(0, 300)
        hardware.sensors.measure(2, 5)
        assertEquals(
            listOf(5, 1023, 300, 320),
            listOf(0xFFE0, 0xFFE2, 0xFFE4, 0xFFE6).map {
                hardware.memory.readWord(it) shr
                    6
            },
        )
    }

    @Test
    fun `all slopes are kept apart from their modes`() {
        for (mode in SensorMode.entries) {
            for (slope in 0..31) assertEquals(mode, SensorMode.of(mode.code + slope))
        }
    }
}
