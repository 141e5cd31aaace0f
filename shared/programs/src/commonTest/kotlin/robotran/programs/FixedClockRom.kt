package robotran.programs

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/**
 * A ROM that remembers what is called, with a clock that stands still while a program computes, so that programs of
 * different speed can be compared. Its sensors measure what [sensors] say at the time; no button is pressed, and the
 * battery is full.
 */
internal class StandingClockRom(private val sensors: List<SensorEvent>) : Rom {
    private val modes = IntArray(SensorCode.PORTS) { SensorCode.MODE_PERCENT }

    /** The calls of the program with their times, without those of the firmware. */
    val calls = mutableListOf<TimedCall>()

    override val memory = RcxMemory()

    /** A brick that runs a program has been on for some time. */
    override var milliseconds: Long = 1

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        if (sourceLine > 0) calls += TimedCall(milliseconds, call.withoutPlaces())
        if (call.address == RomAddress.READ_POWER_STATUS) memory.writeShort(call.arguments[1], FULL_BATTERY)
    }

    override fun readSensor(port: Int, request: SensorRequest): Int {
        val raw =
            sensors.lastOrNull { it.port == port + 1 && it.milliseconds <= milliseconds }?.raw ?: SensorCode.OPEN_RAW
        val boolean = if (raw < TRUE_BELOW) 1 else 0
        return when (request) {
            SensorRequest.RAW -> raw

            SensorRequest.BOOLEAN -> boolean

            SensorRequest.CANONICAL -> if (modes[port] ==
                SensorCode.MODE_BOOLEAN
            ) {
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

/** From [milliseconds] on, the sensor on [port] 1..3 measures [raw]. */
internal data class SensorEvent(val port: Int, val milliseconds: Long, val raw: Int)

/** A call and when it was made. */
internal data class TimedCall(val milliseconds: Long, val call: RomCall) {
    override fun toString(): String =
        "$milliseconds ${call.address.toString(radix = 16)} ${call.arguments.map { it.toShort() }}"
}

/** The lines of a test program that say what sensors measure. */
internal fun sensorsIn(text: String): List<SensorEvent> = SENSOR.findAll(text).map { match ->
    val (port, milliseconds, raw) = match.destructured
    SensorEvent(port.toInt(), milliseconds.toLong(), raw.toInt())
}.toList()

private val SENSOR = Regex("""sensor (\d) at (\d+): raw (\d+)""")
