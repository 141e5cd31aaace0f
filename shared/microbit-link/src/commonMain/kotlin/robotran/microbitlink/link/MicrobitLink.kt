package robotran.microbitlink.link

import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.StateFlow
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.microbitlink.BoardDescription
import robotran.microbitlink.BoardError
import robotran.microbitlink.BoardResult
import robotran.microbitlink.ImageResult
import robotran.microbitlink.Remains
import robotran.microbitlink.SendResult
import robotran.microbitlink.dap.DapLine
import robotran.microbitlink.dap.DapPort
import robotran.microbitlink.files.MAIN_FILE
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.serial.BoardConsole
import robotran.microbitlink.serial.OutputReader
import robotran.microbitlink.serial.RawRepl
import robotran.microbitlink.serial.SerialLine
import kotlin.time.Duration.Companion.milliseconds

/**
 * Talks to a micro:bit by its debug interface. Nothing here has been tried on a real board, see `docs/microbit-link.md`.
 *
 * Calls wait for each other and may be cancelled at any moment. Begin with [open].
 */
class MicrobitLink(port: DapPort) {
    private val line = DapLine(port)
    private val serial = SerialLine(line)
    private val oneAtATime = Mutex()
    private val known = MutableStateFlow(MicrobitState())
    private var output = OutputReader()

    /** What the board does. After a call that was cancelled, it tells what the board holds. */
    val state: StateFlow<MicrobitState> get() = known

    /** Finds out what the board is. One that is no micro:bit stays connected: close the link then. */
    suspend fun open(): BoardResult<BoardDescription> = exclusively {
        val result = meetBoard(line)
        if (result is BoardResult.Success) known.update { it.copy(description = result.value) }
        result
    }

    /**
     * Puts MicroPython of [file] onto the board, with [program] to start. It takes half a minute. Whatever was on the board is
     * gone from the first piece on; after a failure it may hold a part, which [MicrobitState.holds] tells.
     */
    suspend fun flash(file: MicroPythonFile, program: ByteArray): SendResult = sending {
        val board = known.value.description ?: return@sending SendResult.Failure(BoardError.OutOfReach)
        val image = when (val result = file.imageFor(board.board)) {
            is ImageResult.Success -> result.value.withFiles(mapOf(MAIN_FILE to program))
            is ImageResult.Failure -> result
        }
        when (image) {
            is ImageResult.Failure -> SendResult.Failure(BoardError.BadFile(image.error))

            is ImageResult.Success -> {
                val hex = image.value.hexText(LONGEST_RECORD)
                HexFlash(line, board, hex, { now -> known.update { it.copy(sending = now) } }, ::hold).run()
            }
        }
    }

    /**
     * Puts [program] alone onto a board that has MicroPython, in a few seconds, and starts it. Other files of the board
     * stay. If Python does not answer, [flash] helps.
     */
    suspend fun sendMain(program: ByteArray): SendResult = sending {
        if (known.value.description == null) return@sending SendResult.Failure(BoardError.OutOfReach)
        val send = ReplSend(line, serial, program, { now -> known.update { it.copy(sending = now) } }, ::hold)
        val result = send.run()
        // The old program goes on, too, but never a part of one.
        val isWhole = known.value.holds == Remains.AS_SENT || known.value.holds == Remains.AS_BEFORE
        if (isWhole && !line.isGone) RawRepl(serial).restart()
        result
    }

    /**
     * Reads what the board's program prints into [state], until it is cancelled or fails. While a program is sent, it waits. It
     * may start the board again, once.
     */
    suspend fun watch(): BoardError {
        var failures = 0
        while (failures < MOST_FAILURES && !line.isGone) {
            val bytes = exclusively { if (serial.prepare()) serial.read() else null }
            if (bytes == null) failures++ else failures = 0
            if (bytes == null || bytes.isEmpty()) {
                delay(POLL)
            } else {
                output.add(bytes)
                known.update { it.copy(console = output.console) }
            }
        }
        return if (line.isGone) BoardError.OutOfReach else BoardError.BadConnection
    }

    /** Forgets what was printed. */
    fun clearConsole() {
        output = OutputReader()
        known.update { it.copy(console = BoardConsole()) }
    }

    /** Releases the board. Its program goes on. */
    suspend fun close() = withContext(NonCancellable) {
        line.close()
        known.update { it.copy(isGone = true) }
    }

    private suspend fun sending(work: suspend () -> SendResult): SendResult = exclusively {
        clearConsole()
        hold(Remains.AS_BEFORE)
        try {
            work()
        } finally {
            known.update { it.copy(sending = null) }
        }
    }

    private fun hold(remains: Remains) = known.update { it.copy(holds = remains) }

    private suspend fun <T> exclusively(work: suspend () -> T): T = oneAtATime.withLock {
        try {
            work()
        } finally {
            if (line.isGone) known.update { it.copy(isGone = true) }
        }
    }

    private companion object {
        /** What a board takes in one line, which makes the text a fifth shorter than usual. */
        const val LONGEST_RECORD = 32
        const val MOST_FAILURES = 5
        val POLL = 20.milliseconds
    }
}
