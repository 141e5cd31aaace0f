package robotran.workshop.send

import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.launch
import robotran.microbitlink.BoardError
import robotran.microbitlink.ImageResult
import robotran.microbitlink.Remains
import robotran.microbitlink.SendResult
import robotran.microbitlink.dap.PluggedBoard
import robotran.microbitlink.image.MicroPythonFile
import robotran.microbitlink.link.MicrobitLink
import robotran.microbitlink.link.MicrobitState
import robotran.workshop.state.FoundBoard
import robotran.workshop.state.MicrobitSendStep

/** What is sent: the program, and MicroPython for a board that has none; null if the pupil has chosen none. */
internal class MicrobitSending(val program: MicrobitTranslation.Success, val microPython: MicroPythonFile?)

/**
 * Sends programs to a board at USB, and follows what they print.
 *
 * @param show is told each step.
 * @param meet is told what the board is.
 */
internal class MicrobitUsbSending(
    private val session: MicrobitSession,
    private val show: (MicrobitSendStep) -> Unit,
    private val meet: (FoundBoard) -> Unit,
) {
    val link: MicrobitLink? get() = session.link
    val device: PluggedBoard? get() = session.device
    val lastUsed: PluggedBoard? get() = session.lastUsed

    /** Connects [board] unless it is connected, and sends if the pupil knows it. */
    suspend fun connect(board: PluggedBoard, sending: MicrobitSending, isKnown: Boolean = board == lastUsed) {
        show(MicrobitSendStep.Connecting)
        session.open(board)?.let { return fail(it) }
        val type = session.link?.state?.value?.description?.board ?: return fail(BoardError.OutOfReach)
        val found = FoundBoard(type, expected = sending.program.board.takeIf { it != type })
        meet(found)
        if (isKnown && found.expected == null) send(sending) else show(MicrobitSendStep.Found)
    }

    /** Sends the program alone, or everything if no MicroPython answers. */
    suspend fun send(sending: MicrobitSending) {
        val link = session.link ?: return fail(BoardError.OutOfReach)
        val result = transfer(link, isWhole = false) { link.sendMain(sending.program.bytes) }
        val hasNoPython = (result as? SendResult.Failure)?.error == BoardError.NoPython
        if (hasNoPython && sending.canSendWhole(link)) sendWhole(sending) else end(link, result, sending)
    }

    /** Sends MicroPython with the program in it. */
    suspend fun sendWhole(sending: MicrobitSending) {
        val link = session.link ?: return fail(BoardError.OutOfReach)
        val file = sending.microPython ?: return fail(BoardError.NoPython)
        end(link, transfer(link, isWhole = true) { link.flash(file, sending.program.bytes) }, sending)
    }

    suspend fun close() = session.close()

    /** Whether there is MicroPython for the board of [link]. */
    private fun MicrobitSending.canSendWhole(link: MicrobitLink): Boolean =
        link.state.value.description?.let { microPython?.imageFor(it.board) } is ImageResult.Success

    /** Tells how far [send] is, as long as it works. */
    private suspend fun transfer(link: MicrobitLink, isWhole: Boolean, send: suspend () -> SendResult): SendResult =
        coroutineScope {
            show(MicrobitSendStep.Sending(null, isWhole))
            val reports = launch {
                link.state.collect { if (it.sending != null) show(MicrobitSendStep.Sending(it.sending, isWhole)) }
            }
            try {
                send()
            } finally {
                reports.cancel()
            }
        }

    private suspend fun end(link: MicrobitLink, result: SendResult, sending: MicrobitSending) = when (result) {
        is SendResult.Failure -> {
            // The same would happen again, or Python is not there.
            val helps = result.error in WHOLE_HELPS && sending.canSendWhole(link)
            fail(result.error, result.remains, helps)
        }

        is SendResult.Success -> {
            session.remember()
            follow(link, sending.program)
        }
    }

    /** Shows what the program prints until the board is gone or does not answer. */
    private suspend fun follow(link: MicrobitLink, program: MicrobitTranslation.Success) {
        show(MicrobitSendStep.Running())
        coroutineScope {
            val watching = launch { link.watch() }
            val showing = launch {
                link.state.first { board ->
                    show(runningOf(board, program))
                    board.isGone
                }
            }
            watching.join()
            showing.cancel()
        }
        // Whether it is unplugged or only silent: the program goes on, and nothing more comes.
        show(runningOf(link.state.value, program).copy(isGone = true))
        session.close()
    }

    private fun runningOf(board: MicrobitState, program: MicrobitTranslation.Success) = MicrobitSendStep.Running(
        board.console,
        errorLine = board.console.error?.line?.let(program.lineOf),
        board.isGone,
    )

    private suspend fun fail(error: BoardError, remains: Remains = Remains.AS_BEFORE, canSendWhole: Boolean = false) {
        if (session.link?.state?.value?.isGone == true) session.close()
        show(MicrobitSendStep.Failed(error, remains, canSendWhole))
    }

    private companion object {
        /** Errors of the program alone after which everything may arrive. */
        val WHOLE_HELPS = setOf(BoardError.NoPython, BoardError.NoRoom, BoardError.NotAsSent)
    }
}
