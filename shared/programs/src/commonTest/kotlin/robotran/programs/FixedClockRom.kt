package robotran.programs

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/**
 * A ROM that records its calls. Its clock stands still while a program computes, so that programs of different speeds
 * can be compared. Its sensors return the values of [sensors] for the current time. No button is pressed, and the
 * battery is full.
 */
internal class FixedClockRom(private val sensors: List<SensorEvent>) : Rom {
    private val modes = IntArray(SensorCode.PORTS) { SensorCode.MODE_PERCENT }

    /** The calls of the program with their times, without the firmware's own calls. */
    val calls = mutableListOf<TimedCall>()

    override val memory = RcxMemory()

    /** A brick is already on for some time when a program starts. */
    override var milliseconds: Long = 1

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        if (sourceLine > 0) calls += TimedCall(milliseconds, call.withoutAddresses())
        if (call.address == RomAddress.READ_POWER_STATUS) memory.writeShort(call.arguments[1], FULL_BATTERY)
    }

    override fun readSensor(port: Int, request: SensorRequest): Int {
        val raw =
            sensors.lastOrNull { it.port == port + 1 && it.milliseconds <= milliseconds }?.raw ?: SensorCode.OPEN_RAW
        val boolean = if (raw < TRUE_BELOW) 1 else 0
        return when (request) {
            SensorRequest.RAW -> raw
            SensorRequest.BOOLEAN -> boolean

            SensorRequest.CANONICAL -> if (modes[port] == SensorCode.MODE_BOOLEAN) {
                boolean
            } else {
                (SensorCode.OPEN_RAW - raw) * 25 / 156
            }
        }
    }

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) {
        modes[port] = mode
    }

    override fun setSensorValue(port: Int, value: Int, field: SensorField) {
        if (field == SensorField.MODE) modes[port] = value
    }

    private companion object {
        const val FULL_BATTERY = 320
        const val TRUE_BELOW = 460
    }
}

/** From time [milliseconds] on, the sensor on [port], from 1 to 3, has the raw value [raw]. */
internal data class SensorEvent(val port: Int, val milliseconds: Long, val raw: Int)

/** A ROM call and its time. */
internal data class TimedCall(val milliseconds: Long, val call: RomCall) {
    override fun toString(): String =
        "$milliseconds ${call.address.toString(radix = 16)} ${call.arguments.map { it.toShort() }}"
}

/** The sensor values that the comments of a test program specify. */
internal fun sensorsIn(text: String): List<SensorEvent> = SENSOR.findAll(text).map { match ->
    val (port, milliseconds, raw) = match.destructured
    SensorEvent(port.toInt(), milliseconds.toLong(), raw.toInt())
}.toList()

private val SENSOR = Regex("""sensor (\d) at (\d+): raw (\d+)""")
