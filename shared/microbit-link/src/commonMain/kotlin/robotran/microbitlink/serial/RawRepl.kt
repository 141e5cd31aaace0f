package robotran.microbitlink.serial

import kotlinx.coroutines.delay
import kotlin.time.Duration
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/** What Python said to some lines: what they printed, and why they ended early, if they did. */
internal class ReplAnswer(val output: String, val error: String)

/** Python's prompt for machines, at the end of a serial line. */
internal class RawRepl(private val serial: SerialLine) {
    /** Interrupts the program and comes to the prompt; false if it does not come. */
    suspend fun enter(): Boolean {
        repeat(TRIES) {
            if (interrupt() && softReset()) return true
        }
        return false
    }

    /** Runs [lines]; null if it is not sure what came of them. */
    suspend fun run(lines: String, time: Duration = USUAL): ReplAnswer? {
        if (!serial.write(lines.encodeToByteArray() + END)) return null
        val answer = serial.readUntil(byteArrayOf(END, PROMPT), time) ?: return null
        val text = answer.copyOf(answer.size - 1).decodeToString()
        val parts = text.removePrefix(OK).split(END.toInt().toChar())
        // What was printed, what went wrong, and nothing behind.
        val isWhole = text.startsWith(OK) && parts.size == 3 && parts.last().isEmpty()
        return if (isWhole) ReplAnswer(parts[0], parts[1]) else null
    }

    /** Leaves the prompt and starts the program of the board. What Python says about that is no output of the program. */
    suspend fun restart(): Boolean = serial.write(byteArrayOf(FRIENDLY)) && serial.write(byteArrayOf(END)) &&
        serial.readUntil(REBOOT, ANSWER) != null

    private suspend fun interrupt(): Boolean {
        if (!serial.write(byteArrayOf(FRIENDLY))) return false
        repeat(INTERRUPTIONS) {
            if (!serial.write(byteArrayOf(RETURN, INTERRUPT))) return false
        }
        delay(SETTLE)
        serial.skip()
        return serial.write(byteArrayOf(RETURN, RAW)) && serial.readUntil(BANNER, ANSWER) != null
    }

    /** So that nothing of the program is left in memory. */
    private suspend fun softReset(): Boolean {
        if (!serial.write(byteArrayOf(END))) return false
        return serial.readUntil(REBOOT, ANSWER) != null && serial.readUntil(BANNER, ANSWER) != null
    }

    private companion object {
        const val RAW: Byte = 0x01
        const val FRIENDLY: Byte = 0x02
        const val INTERRUPT: Byte = 0x03
        const val END: Byte = 0x04
        const val RETURN: Byte = 0x0D
        const val PROMPT = '>'.code.toByte()
        const val OK = "OK"
        val BANNER = "raw REPL; CTRL-B to exit\r\n>".encodeToByteArray()
        val REBOOT = "soft reboot\r\n".encodeToByteArray()
        const val TRIES = 3
        const val INTERRUPTIONS = 3
        val SETTLE = 100.milliseconds
        val ANSWER = 2.seconds
        val USUAL = 5.seconds
    }
}
