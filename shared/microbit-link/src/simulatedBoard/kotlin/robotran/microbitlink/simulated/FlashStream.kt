package robotran.microbitlink.simulated

import robotran.microbitlink.ImageResult
import robotran.microbitlink.hex.HexFile
import robotran.microbitlink.hex.HexMemory
import robotran.microbitlink.hex.readHex

/** What DAPLink does with a hex that comes in pieces. It erases everything first. */
internal class FlashStream(private var before: HexMemory, private val isNewer: Boolean) {
    private enum class State { CLOSED, OPEN, ENDED, FAILED }

    private var state = State.CLOSED
    private val line = StringBuilder()
    private val text = StringBuilder()
    private var written: HexMemory? = null
    private var commands = 0

    /** What the flash holds. */
    val memory: HexMemory get() = written ?: before

    fun replace(memory: HexMemory) {
        before = memory
        written = null
    }

    fun open(type: Int): Int {
        if (state != State.CLOSED || type != HEX) return INTERNAL
        state = State.OPEN
        line.clear()
        text.clear()
        return 0
    }

    fun close(): Int {
        if (state == State.CLOSED) return INTERNAL
        state = State.CLOSED
        replace(memory)
        return 0
    }

    fun write(bytes: ByteArray, injectedError: InjectedError?): Int {
        if (state != State.OPEN) return INTERNAL
        commands++
        val number = when {
            injectedError != null && injectedError.isAt(commands) -> injectedError.number
            else -> parse(bytes.decodeToString())
        }
        if (number != 0) state = if (number == end) State.ENDED else State.FAILED
        return number
    }

    private val end get() = if (isNewer) 19 else 16

    private fun parse(piece: String): Int {
        for (letter in piece) {
            if (letter == '\n') continue
            line.append(letter)
            val length = if (line.length >= 3) line.substring(1, 3).toIntOrNull(16) ?: return parserError else continue
            if (line.length < FRAME + 2 * length) continue
            val whole = line.toString()
            line.clear()
            // The reader of files tells whether the line is sound.
            if (readHex("$whole\n:00000001FF\n") is ImageResult.Failure) return checksumError
            if (whole.startsWith(":00000001")) return flush().let { end }
            text.append(whole).append('\n')
        }
        flush()
        return 0
    }

    /** Writes what has come so far. */
    private fun flush() {
        val read = readHex("$text:00000001FF\n") as? ImageResult.Success ?: return
        written = (read.value as? HexFile.Plain)?.memory ?: written
    }

    private val parserError get() = if (isNewer) 22 else 19
    private val checksumError get() = if (isNewer) 21 else 18

    private companion object {
        const val HEX = 1
        const val INTERNAL = 2
        const val FRAME = 11
    }
}
