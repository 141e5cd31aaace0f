package robotran.microbitlink.dap

import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.withContext
import kotlinx.coroutines.withTimeoutOrNull
import robotran.microbitlink.u8
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** What became of a command. */
internal sealed interface DapAnswer {
    /** What stands behind the command's number, with zeros up to the end of the packet. */
    class Good(val bytes: ByteArray) : DapAnswer

    /** No answer, or one to something else: the board may have done it or not. */
    data object Unanswered : DapAnswer

    /** The board is gone: it may have done it or not. */
    data object Gone : DapAnswer
}

/**
 * Commands to a board, one at a time, and their answers. A command that was begun is ended even if its caller is
 * cancelled: its answer would be taken for that to the next one.
 */
internal class DapLine(private val port: DapPort) {
    /** Whether answers to earlier commands may still come. */
    private var isUnsure = true

    var isGone = false
        private set

    suspend fun command(vararg bytes: Int, timeout: Duration = USUAL): DapAnswer =
        command(ByteArray(bytes.size) { bytes[it].toByte() }, timeout)

    suspend fun command(bytes: ByteArray, timeout: Duration = USUAL): DapAnswer = withContext(NonCancellable) {
        if (isUnsure && !drain()) return@withContext unsure()
        ask(bytes, timeout)
    }

    suspend fun close() {
        port.close()
        isGone = true
    }

    private suspend fun ask(bytes: ByteArray, timeout: Duration): DapAnswer {
        val answer = withTimeoutOrNull(timeout) { if (send(bytes)) receive(bytes.u8(0)) else null } ?: return unsure()
        if (answer.u8(0) != bytes.u8(0)) return unsure()
        return DapAnswer.Good(answer.copyOfRange(1, answer.size).copyOf(PACKET - 1))
    }

    private suspend fun send(bytes: ByteArray): Boolean {
        if (!isGone && !port.send(bytes.copyOf(PACKET))) isGone = true
        return !isGone
    }

    /** The next packet but for late answers to what has drained the line; null if the board is gone. */
    private suspend fun receive(command: Int): ByteArray? {
        while (true) {
            val packet = port.receive()
            if (packet == null) {
                isGone = true
                return null
            }
            if (packet.isNotEmpty() && (packet.u8(0) != DapCommand.INFO || command == DapCommand.INFO)) return packet
        }
    }

    /** Reads answers of an earlier session or command away, until one comes to a question that changes nothing. */
    private suspend fun drain(): Boolean {
        val question = byteArrayOf(DapCommand.INFO.toByte(), DapCommand.VENDOR_NAME.toByte())
        for (draining in 1..DRAININGS) {
            val isClean = withTimeoutOrNull(DRAIN) { send(question) && hasAnswer() }
            if (isClean == true) isUnsure = false
            if (isClean == true || isGone) break
        }
        return !isUnsure
    }

    /** Whether the answer to a question comes before too many others. */
    private suspend fun hasAnswer(): Boolean {
        repeat(MOST_STALE) {
            val packet = receive(DapCommand.INFO) ?: return false
            if (packet.u8(0) == DapCommand.INFO) return true
        }
        return false
    }

    private fun unsure(): DapAnswer {
        isUnsure = true
        return if (isGone) DapAnswer.Gone else DapAnswer.Unanswered
    }

    private companion object {
        const val PACKET = 64
        const val DRAININGS = 3
        const val MOST_STALE = 64
        val USUAL = 2.seconds
        val DRAIN = 600.milliseconds
    }
}

/** The numbers of commands. */
internal object DapCommand {
    const val INFO = 0x00
    const val UNIQUE_ID = 0x80
    const val SERIAL_SETTINGS = 0x81
    const val SET_BAUD_RATE = 0x82
    const val READ_SERIAL = 0x83
    const val WRITE_SERIAL = 0x84
    const val RESET = 0x89
    const val OPEN_STREAM = 0x8A
    const val CLOSE_STREAM = 0x8B
    const val WRITE_STREAM = 0x8C

    // What INFO is asked for.
    const val VENDOR_NAME = 0x01
    const val PRODUCT_VERSION = 0x09

    /** Of an Intel hex. */
    const val HEX_STREAM = 1

    /** What a packet has room for behind number and length. */
    const val PAYLOAD = 62
}
