package robotran.microbitlink.link

import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.currentCoroutineContext
import kotlinx.coroutines.delay
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.withContext
import robotran.microbitlink.BoardDescription
import robotran.microbitlink.BoardError
import robotran.microbitlink.DaplinkNumbers
import robotran.microbitlink.Remains
import robotran.microbitlink.SendProgress
import robotran.microbitlink.SendResult
import robotran.microbitlink.dap.DapAnswer
import robotran.microbitlink.dap.DapCommand
import robotran.microbitlink.dap.DapLine
import robotran.microbitlink.u8
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * A whole hex on its way onto a board. Each piece goes after the answer to the one before. The board checks every line,
 * writes, and starts the program when the stream is closed. Whatever goes wrong, the stream is closed: a board takes no
 * other while one is open. A piece whose answer stays away cannot go again, so the whole file does.
 *
 * @param hex for this board alone: a board overlooks its part of a universal hex that comes in small pieces.
 * @param hold is told what the board has, whenever that changes.
 */
internal class HexFlash(
    private val line: DapLine,
    board: BoardDescription,
    hex: String,
    private val report: (SendProgress) -> Unit,
    private val hold: (Remains) -> Unit,
) {
    private val bytes = hex.encodeToByteArray()
    private val numbers = DaplinkNumbers.of(board.board, board.daplink)
    private var isOpen = false
    private var remains = Remains.AS_BEFORE
        set(value) {
            field = value
            hold(value)
        }

    suspend fun run(): SendResult {
        var last: BoardError = BoardError.BadConnection
        for (attempt in 1..ATTEMPTS) {
            when (val end = attempt(attempt)) {
                null -> return SendResult.Success(attempt).also { remains = Remains.AS_SENT }
                is BoardError.Refused -> if (!end.kind.mayPass) return SendResult.Failure(end, remains) else last = end
                BoardError.BadConnection -> last = end
                else -> return SendResult.Failure(end, remains)
            }
            delay(PAUSE)
        }
        return SendResult.Failure(last, remains)
    }

    /** Null if the board has confirmed everything. */
    private suspend fun attempt(attempt: Int): BoardError? {
        try {
            open()?.let { return it }
            var from = 0
            var hasEnded = false
            while (from < bytes.size && !hasEnded) {
                if (from % REPORTED == 0) report(SendProgress(from, bytes.size, attempt))
                currentCoroutineContext().ensureActive()
                val to = minOf(from + DapCommand.PAYLOAD, bytes.size)
                // The last line may be whole without its end.
                val isAtEnd = to >= bytes.size - 1
                if (to >= bytes.size - LAST_LINE) remains = Remains.UNKNOWN
                val answer = line.command(pieceOf(from, to), timeout = SLOW)
                hasEnded = isAtEnd && answer.number in numbers.ends
                if (!hasEnded) errorOf(answer)?.let { return it }
                from = to
            }
            return close().also { if (it == null) report(SendProgress(bytes.size, bytes.size, attempt)) }
        } finally {
            if (isOpen) withContext(NonCancellable) { close() }
        }
    }

    private fun pieceOf(from: Int, to: Int): ByteArray =
        byteArrayOf(DapCommand.WRITE_STREAM.toByte(), (to - from).toByte()) + bytes.copyOfRange(from, to)

    private suspend fun open(): BoardError? {
        val before = remains
        // Nothing is erased yet: an earlier attempt may have sent everything.
        if (before != Remains.UNKNOWN) remains = Remains.PART
        isOpen = true
        val error = errorOf(line.command(DapCommand.OPEN_STREAM, DapCommand.HEX_STREAM, timeout = SLOW))
        // What is refused at once has changed nothing.
        if (error is BoardError.Refused) remains = before
        return error
    }

    private suspend fun close(): BoardError? {
        isOpen = false
        val error = errorOf(line.command(DapCommand.CLOSE_STREAM, timeout = SLOW))
        if (error == null) line.command(DapCommand.RESET)
        return error
    }

    /** What the board says; null if it says nothing. */
    private val DapAnswer.number: Int? get() = (this as? DapAnswer.Good)?.bytes?.u8(0)

    /** The error of [answer]; null if it is good. */
    private fun errorOf(answer: DapAnswer): BoardError? = when (answer) {
        DapAnswer.Gone -> if (remains == Remains.AS_BEFORE) BoardError.OutOfReach else BoardError.BrokenOff
        DapAnswer.Unanswered -> BoardError.BadConnection
        is DapAnswer.Good -> answer.number?.takeIf { it != 0 }?.let { BoardError.Refused(it, numbers.kindOf(it)) }
    }

    private companion object {
        const val ATTEMPTS = 3

        /** The characters of the last line, which says nothing but that it is the last. */
        const val LAST_LINE = 12

        /** Bytes from one report to the next, in whole pieces. */
        const val REPORTED = DapCommand.PAYLOAD * 16
        val SLOW = 10.seconds
        val PAUSE = 300.milliseconds
    }
}
