package robotran.robolang

import robotran.rom.RcxMemory
import robotran.rom.Rom
import robotran.rom.RomCall

/** A ROM that does nothing but remember, with a clock that is set by hand. */
internal class RecordingRom : Rom {
    val calls = mutableListOf<RecordedCall>()

    override val memory = RcxMemory()

    override var milliseconds: Long = 0

    private val sensors = IntArray(3) { 1023 }

    override fun readSensor(port: Int, request: SensorRequest): Int = 0

    override fun setSensorTypeAndMode(port: Int, type: Int, mode: Int) = Unit

    override fun call(call: RomCall, sourceLine: Int) {
        calls += RecordedCall(milliseconds, call, sourceLine)
    }
}

/** A call, when it was made and on which line of the program. */
internal data class RecordedCall(val milliseconds: Long, val call: RomCall, val sourceLine: Int) {
    override fun toString(): String = "$milliseconds ${textOf(call)} ; $sourceLine"
}

/** [call] as the programs write it: codes hexadecimal, numbers decimal and signed. */
internal fun textOf(call: RomCall): String =
    (listOf(hexadecimal(call.address)) + call.arguments.map { if (it in CODES) hexadecimal(it) else it.toShort().toString() })
        .joinToString(" ")

private fun hexadecimal(value: Int): String = "0x" + value.toString(radix = 16)

private val CODES = 0x1000..0xEFFF
