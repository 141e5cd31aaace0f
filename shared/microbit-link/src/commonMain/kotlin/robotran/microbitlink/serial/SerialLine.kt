package robotran.microbitlink.serial

import kotlinx.coroutines.delay
import kotlinx.coroutines.withTimeoutOrNull
import robotran.microbitlink.dap.DapAnswer
import robotran.microbitlink.dap.DapCommand
import robotran.microbitlink.dap.DapLine
import robotran.microbitlink.fourBytes
import robotran.microbitlink.u32
import robotran.microbitlink.u8
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds

/** The serial line of a board, by commands of its debug interface. */
internal class SerialLine(private val line: DapLine) {
    private var isReady = false

    /** What was read behind what somebody waited for. */
    private var rest = ByteArray(0)

    /** Sets the speed of MicroPython. That starts the board again if it was another; false if it fails. */
    suspend fun prepare(): Boolean {
        if (isReady) return true
        val settings = line.command(DapCommand.SERIAL_SETTINGS) as? DapAnswer.Good ?: return false
        if (settings.bytes.u32(0) != BAUD_RATE.toLong()) {
            val command = byteArrayOf(DapCommand.SET_BAUD_RATE.toByte()) + fourBytes(BAUD_RATE)
            if (line.command(command) !is DapAnswer.Good) return false
        }
        isReady = true
        return true
    }

    /** What has come, perhaps nothing; null if the board does not answer. */
    suspend fun read(): ByteArray? {
        if (rest.isNotEmpty()) return rest.also { rest = ByteArray(0) }
        val answer = line.command(DapCommand.READ_SERIAL) as? DapAnswer.Good ?: return null
        val count = answer.bytes.u8(0)
        return if (count <= DapCommand.PAYLOAD) answer.bytes.copyOfRange(1, 1 + count) else null
    }

    /** Sends [bytes], slowly: nothing tells a board's program to wait. False if that is not sure. */
    suspend fun write(bytes: ByteArray): Boolean {
        for (from in bytes.indices step PIECE) {
            val piece = bytes.copyOfRange(from, minOf(from + PIECE, bytes.size))
            val command = byteArrayOf(DapCommand.WRITE_SERIAL.toByte(), piece.size.toByte()) + piece
            if (line.command(command) !is DapAnswer.Good) return false
            delay(PAUSE)
        }
        return true
    }

    /** Reads to the end of the first [end]; null if that does not come within [time], or too much else before. */
    suspend fun readUntil(end: ByteArray, time: Duration): ByteArray? = withTimeoutOrNull(time) {
        var all = ByteArray(0)
        while (all.size <= MOST) {
            val searched = maxOf(0, all.size - end.size)
            val piece = read() ?: return@withTimeoutOrNull null
            if (piece.isEmpty()) delay(PAUSE)
            all += piece
            val place = all.indexOf(end, searched)
            if (place >= 0) {
                rest = all.copyOfRange(place + end.size, all.size)
                return@withTimeoutOrNull all.copyOf(place + end.size)
            }
        }
        null
    }

    /** Throws away what has come, until nothing more comes. */
    suspend fun skip() {
        repeat(MOST_SKIPPED) {
            val piece = read()
            if (piece == null || piece.isEmpty()) return
        }
    }

    private fun ByteArray.indexOf(other: ByteArray, from: Int): Int =
        (from..size - other.size).firstOrNull { start -> other.indices.all { this[start + it] == other[it] } } ?: -1

    private companion object {
        const val BAUD_RATE = 115_200
        const val PIECE = 32
        val PAUSE = 10.milliseconds
        const val MOST = 20_000
        const val MOST_SKIPPED = 200
    }
}
