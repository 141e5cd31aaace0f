package robotran.rcxrom

import robotran.language.Language
import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.messages.BrickMessages
import robotran.rcxrom.routines.Hardware
import robotran.rcxrom.sensors.RotationSensor
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorMode
import robotran.rcxrom.sensors.SensorRequest
import kotlin.test.Test
import kotlin.test.assertEquals

class RotationTest {
    private val hardware = Hardware(messages = BrickMessages.of(Language.ENGLISH))

    init {
        hardware.rom.setSensorTypeAndMode(0, 4, SensorMode.ANGLE.code)
        hardware.call(RomAddress.ACTIVATE_SENSOR, 0x1000)
    }

    @Test
    fun `sixteen counts make a turn, forwards and backwards`() {
        turnTo(0)
        hardware.rom.setSensorValue(0, 0, SensorField.VALUE)
        for (count in 1..RotationSensor.COUNTS_PER_TURN) turnTo(count)
        assertEquals(16, value())
        for (count in 15 downTo -40) turnTo(count)
        assertEquals(-40, value())
    }

    @Test
    fun `counting goes on from the value that a program sets and wraps like a short`() {
        turnTo(0)
        hardware.rom.setSensorValue(0, 32_767, SensorField.VALUE)
        turnTo(1)
        assertEquals(-32_768, value())
    }

    @Test
    fun `a sensor that is not active counts nothing`() {
        hardware.call(RomAddress.PASSIVATE_SENSOR, 0x1000)
        repeat(20) { turnTo(it) }
        assertEquals(0, value())
    }

    @Test
    fun `a turn too fast to be read twice in each place is lost`() {
        turnTo(0)
        hardware.rom.setSensorValue(0, 0, SensorField.VALUE)
        for (count in 1..16) turnTo(count, milliseconds = 3)
        assertEquals(0, value())
    }

    @Test
    fun `the routine of the ROM counts at once`() {
        hardware.memory.writeByte(RESULT + 1, SensorMode.ANGLE.code)
        for (count in listOf(0, 1, 2, 3, 2)) {
            hardware.sensors.measure(1, RotationSensor.raw(count, active = true))
            hardware.call(RomAddress.READ_SENSOR, 0x1001, RESULT)
        }
        assertEquals(2, hardware.memory.readShort(RESULT + 4))
    }

    private fun turnTo(count: Int, milliseconds: Int = 6) {
        hardware.sensors.measure(0, RotationSensor.raw(count, hardware.sensors.isActive(0)))
        hardware.tick(milliseconds)
    }

    private fun value() = hardware.rom.readSensor(0, SensorRequest.CANONICAL)
}
