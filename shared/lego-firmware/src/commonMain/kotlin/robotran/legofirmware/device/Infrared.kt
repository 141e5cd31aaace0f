package robotran.legofirmware.device

import robotran.rcxrom.call.RomAddress
import robotran.rcxrom.call.RomCode

/** Messages between bricks, and bytes of the serial buffer of firmware 2.0. */
internal class Infrared(private val calls: RomCalls) {
    private val rom = calls.rom
    private val buffer = IntArray(BUFFER_PLACES)
    private var sendsPlainBytes = false

    /** The last received message, 1..255; 0 if there is none. */
    var message = 0

    var isLong = false
        private set

    /** Whether nothing is being sent. */
    val isFree: Boolean get() = rom.memory.readByte(SEND_STATE) == IDLE && !rom.infraredLine.isSending

    fun setRange(isLong: Boolean) {
        this.isLong = isLong
        calls.call(if (isLong) RomAddress.SET_RANGE_LONG else RomAddress.SET_RANGE_SHORT, RomCode.RANGE)
    }

    /** Sends a packet; only if [isFree]. */
    fun send(vararg bytes: Int) {
        bytes.forEachIndexed { place, byte -> rom.memory.writeByte(RomCalls.MESSAGE + place, byte) }
        calls.call(RomAddress.SEND_DATA, RomCode.SEND_SHORT, 0, RomCalls.MESSAGE, bytes.size)
    }

    /** Takes a received packet, the opcode first; null if none waits. */
    fun receive(): List<Int>? {
        if (!rom.hasMessage) return null
        rom.memory.writeByte(RomCalls.RESULT, 0)
        calls.call(RomAddress.RECEIVE_DATA, RomCalls.MESSAGE, LONGEST, RomCalls.RESULT)
        return List(rom.memory.readByte(RomCalls.RESULT)) { rom.memory.readByte(RomCalls.MESSAGE + it) }
    }

    /** A place of the serial buffer: bytes 0..15, 16 the format of packets, 17 the carrier. */
    fun serial(index: Int): Int = buffer.getOrElse(index) { 0 }

    fun setSerial(index: Int, value: Int) {
        if (index in buffer.indices) buffer[index] = value and BYTE
    }

    /** Sends [count] bytes of the buffer from [first] on, in its format; only if [isFree]. */
    fun sendSerial(first: Int, count: Int) {
        val data = (first until first + count).filter { it < DATA_BYTES }.map { buffer[it] }
        val format = buffer[FORMAT_PLACE]
        val summed = if (format and CHECKSUM != 0) data + (data.sum() and BYTE) else data
        val body = if (format and NEGATED != 0) summed.flatMap { listOf(it, it.inv() and BYTE) } else summed
        val bytes = if (format and PREAMBLE != 0) HEADER + body else body
        if (bytes.isEmpty()) return
        rom.infraredLine.begin()
        rom.infraredLine.write(bytes)
        sendsPlainBytes = true
    }

    /** Gives the port back to the ROM after plain bytes. */
    fun tick() {
        if (!sendsPlainBytes || rom.infraredLine.isSending) return
        sendsPlainBytes = false
        calls.asFirmware {
            calls.call(RomAddress.INIT_SERIAL, 0, 0, 1, 1)
            if (isLong) calls.call(RomAddress.SET_RANGE_LONG, RomCode.RANGE)
        }
    }

    private companion object {
        /** The ROM's byte that says whether it sends, and its value if not. */
        const val SEND_STATE = 0xEF93
        const val IDLE = 0x4F

        /** The ROM keeps so many bytes of a packet. */
        const val LONGEST = 9
        const val BYTE = 0xFF
        const val BUFFER_PLACES = 18
        const val DATA_BYTES = 16
        const val FORMAT_PLACE = 16
        const val PREAMBLE = 1
        const val NEGATED = 2
        const val CHECKSUM = 4
        val HEADER = listOf(0x55, 0xFF, 0x00)
    }
}
