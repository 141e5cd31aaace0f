package robotran.microbitlink.link

import robotran.microbitlink.BoardError
import robotran.microbitlink.ImageError
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.SendResult
import robotran.microbitlink.dap.DapLine
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.serial.RawRepl
import robotran.microbitlink.serial.SerialLine
import robotran.microbitlink.u8
import kotlin.time.Duration.Companion.seconds

/**
 * A program on its way into a board that has MicroPython, line by line at Python's prompt. At the end the board reads the
 * file and tells what it holds: only what is the same counts as sent.
 *
 * @param hold is told what the board has, whenever that changes.
 */
internal class ReplSend(
    private val line: DapLine,
    private val serial: SerialLine,
    private val program: ByteArray,
    private val report: (SendProgress) -> Unit,
    private val hold: (Remains) -> Unit,
) {
    private val repl = RawRepl(serial)
    private var remains = Remains.AS_BEFORE
        set(value) {
            field = value
            hold(value)
        }

    suspend fun run(): SendResult {
        if (program.isEmpty()) return failure(BoardError.BadFile(ImageError.EmptyFile(MAIN_FILE)))
        var last: BoardError = BoardError.BadConnection
        for (attempt in 1..ATTEMPTS) {
            last = attempt(attempt) ?: return SendResult.Success(attempt)
            if (last !in WORTH_REPEATING) break
        }
        return failure(last)
    }

    /** Null if the board holds the program. */
    private suspend fun attempt(attempt: Int): BoardError? {
        report(SendProgress(0, program.size, attempt))
        if (!serial.prepare()) return lost()
        if (!repl.enter()) return if (line.isGone) lost() else BoardError.NoPython
        remains = if (remains == Remains.PART) Remains.PART else Remains.UNKNOWN
        step("f=open('$MAIN_FILE','wb')")?.let { return it }
        for (from in program.indices step PIECE) {
            val to = minOf(from + PIECE, program.size)
            remains = if (to == program.size) Remains.UNKNOWN else Remains.PART
            step("f.write(${bytesLiteral(program.copyOfRange(from, to))})")?.let { return it }
            report(SendProgress(to, program.size, attempt))
        }
        step("f.close()")?.let { return it }
        val told = repl.run(FINGERPRINT, READING)?.output?.trim() ?: return lost()
        // The question may have been damaged on its way, too.
        if (told != fingerprint(program)) return BoardError.NotAsSent
        remains = Remains.AS_SENT
        return null
    }

    /** The error of one line; null if it did what it should. */
    private suspend fun step(python: String): BoardError? {
        val answer = repl.run(python) ?: return lost()
        return when {
            answer.error.isEmpty() -> null
            "OSError" in answer.error -> BoardError.NoRoom
            else -> BoardError.NotAsSent
        }
    }

    private fun lost(): BoardError = when {
        !line.isGone -> BoardError.BadConnection
        remains == Remains.AS_BEFORE -> BoardError.OutOfReach
        else -> BoardError.BrokenOff
    }

    private fun failure(error: BoardError) = SendResult.Failure(error, remains)

    companion object {
        private const val ATTEMPTS = 2
        private const val PIECE = 64
        private val READING = 20.seconds
        private val WORTH_REPEATING = setOf(BoardError.BadConnection, BoardError.NotAsSent)

        /** Python that prints the [fingerprint] of the file, with whole numbers below 2 to the 30th alone. */
        private val FINGERPRINT = """
            f=open('$MAIN_FILE','rb')
            n=0
            a=7
            b=1
            while True:
             d=f.read(32)
             if not d:break
             n+=len(d)
             for c in d:
              a=(a*31+c)%16777213
              b=(b*37+c)%16777199
            f.close()
            print(n,a,b)
        """.trimIndent() + "\n"

        /** How many bytes, and two sums of them, as [FINGERPRINT] tells them. */
        internal fun fingerprint(bytes: ByteArray): String {
            var a = 7
            var b = 1
            for (place in bytes.indices) {
                a = (a * 31 + bytes.u8(place)) % 16_777_213
                b = (b * 37 + bytes.u8(place)) % 16_777_199
            }
            return "${bytes.size} $a $b"
        }

        /** [bytes] as Python writes them, in printable letters. */
        internal fun bytesLiteral(bytes: ByteArray): String = buildString {
            append("b'")
            for (place in bytes.indices) {
                val value = bytes.u8(place)
                val isPlain = value in ' '.code..'~'.code && value != '\''.code && value != '\\'.code
                if (isPlain) append(value.toChar()) else append("\\x").append(value.toString(16).padStart(2, '0'))
            }
            append("'")
        }
    }
}
