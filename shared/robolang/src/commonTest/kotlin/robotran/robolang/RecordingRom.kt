package robotran.robolang

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCall
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.program.Rom
import robotran.rcxrom.sensors.SensorCode
import robotran.rcxrom.sensors.SensorField
import robotran.rcxrom.sensors.SensorRequest

/**
 * A ROM that records its calls, with a clock that the test sets. The sensors return the values of [sensors], as percent
 * or boolean; no button is pressed, and the battery is full.
 */
internal class RecordingRom(private val sensors: List<SensorEvent> = emptyList()) : Rom {
    private val modes = IntArray(3) { SensorCode.MODE_PERCENT }

    val calls = mutableListOf<RecordedCall>()

    /** The ports, 1..3, whose type has been set to a touch sensor, in order. */
    val touchPorts = mutableListOf<Int>()

    override val memory = RcxMemory()

    override var milliseconds: Long = 0

    override fun call(call: RomCall, sourceLine: Int, sourceFile: String?) {
        calls += RecordedCall(milliseconds, call, sourceLine)
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
        if (type == SensorCode.TYPE_TOUCH) touchPorts += port + 1
    }

    override fun setSensorValue(port: Int, value: Int, field: SensorField) =
        error("No program of Robolang sets a sensor's value.")

    private companion object {
        const val FULL_BATTERY = 320
        const val TRUE_BELOW = 460
    }
}

/** From [milliseconds] on, the sensor on [port] 1..3 returns [raw]. */
internal data class SensorEvent(val port: Int, val milliseconds: Long, val raw: Int)

/** A call with its time and its line of the program. */
internal data class RecordedCall(val milliseconds: Long, val call: RomCall, val sourceLine: Int) {
    override fun toString(): String = "$milliseconds ${textOf(call)} ; $sourceLine"
}

/** [call] as in the test programs: codes in hexadecimal, numbers in signed decimal. */
internal fun textOf(call: RomCall): String = (
    listOf(hexadecimal(call.address)) +
        call.arguments.map { if (it in CODES) hexadecimal(it) else it.toShort().toString() }
)
    .joinToString(" ")

private fun hexadecimal(value: Int): String = "0x" + value.toString(radix = 16)

private val CODES = 0x1000..0xEFFF
