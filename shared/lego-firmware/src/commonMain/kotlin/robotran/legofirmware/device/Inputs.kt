package robotran.legofirmware.device

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/** The three sensors, 0..2. The ROM reads and converts them. */
internal class Inputs(private val calls: RomCalls) {
    private val types = IntArray(SensorCode.PORTS)
    private val modes = IntArray(SensorCode.PORTS)

    /** Sets all sensors to type 0 in raw mode, as firmware does when it starts. */
    fun begin() {
        for (port in 0 until SensorCode.PORTS) set(port, 0, 0)
    }

    /** Sets the type, 0..4, with the mode that belongs to it; types 3 and 4 power the port. */
    fun setType(port: Int, type: Int) {
        set(port, type, USUAL_MODES.getOrElse(type) { 0 })
        val routine = if (type in POWERED) RomAddress.ACTIVATE_SENSOR else RomAddress.PASSIVATE_SENSOR
        calls.call(routine, SensorCode.FIRST_PORT + port)
    }

    /** Powers the ports again whose types need it, after the brick was off. */
    fun resume() {
        for (port in 0 until SensorCode.PORTS) {
            if (types[port] in POWERED) calls.call(RomAddress.ACTIVATE_SENSOR, SensorCode.FIRST_PORT + port)
        }
    }

    /** Sets mode and slope, and clears the value. */
    fun setMode(port: Int, mode: Int) = set(port, types[port], mode)

    /** Sets what the sensor has counted to 0. */
    fun clear(port: Int) = calls.rom.setSensorValue(port, 0, SensorField.VALUE)

    fun type(port: Int): Int = types[port]

    fun mode(port: Int): Int = modes[port]

    fun value(port: Int): Int = calls.rom.readSensor(port, SensorRequest.CANONICAL)

    fun raw(port: Int): Int = calls.rom.readSensor(port, SensorRequest.RAW)

    fun boolean(port: Int): Int = calls.rom.readSensor(port, SensorRequest.BOOLEAN)

    private fun set(port: Int, type: Int, mode: Int) {
        types[port] = type
        modes[port] = mode
        calls.rom.setSensorTypeAndMode(port, type, mode)
        clear(port)
    }

    private companion object {
        /** The modes of the types none, touch, temperature, light, rotation: raw, boolean, Celsius, percent, angle. */
        val USUAL_MODES = listOf(0x00, 0x20, 0xA0, 0x80, 0xE0)
        val POWERED = 3..4
    }
}
