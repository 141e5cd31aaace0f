package robotran.workshop.send

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.microbitlink.FlashErrorKind
import robotran.microbitlink.dap.ChosenBoard
import robotran.microbitlink.drive.DriveResult
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.platform.Platform
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramTabs
import robotran.workshop.state.ChoosingProblem
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep
import robotran.workshop.state.MicrobitTransfer
import robotran.workshop.state.ShownNumber
import kotlin.coroutines.cancellation.CancellationException

/**
 * Gets the shown program onto a real micro:bit, step by step: as a file, onto the board's drive or by USB. One piece of
 * work runs at a time. A board at USB stays connected until the sheet is closed; its program then goes on.
 */
internal class MicrobitSendStateHolder(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val current: CurrentProject,
    private val tabs: ProgramTabs,
    private val programs: MicrobitPrograms,
) {
    /** Null while the sheet is closed. */
    var state: MicrobitSendState? by mutableStateOf(null)
        private set

    private val microPython = MicroPythonStore(platform)
    private val usb = MicrobitUsbSending(MicrobitSession(platform.microbits), ::show) { board ->
        state = state?.copy(board = board)
    }
    private val oneAtATime = Mutex()
    private var work: Job? = null
    private var built: MicrobitTranslation.Success? = null

    fun handle(event: MicrobitSendEvent) {
        if (event != MicrobitSendEvent.Requested && state == null) return
        when (event) {
            MicrobitSendEvent.Requested -> if (state == null) begin()
            MicrobitSendEvent.MicroPythonRequested -> run { chooseMicroPython() }
            MicrobitSendEvent.HexSaved -> run { saveHex() }
            MicrobitSendEvent.PythonSaved -> run { savePython() }
            MicrobitSendEvent.DriveRequested -> run { copyToDrive() }
            MicrobitSendEvent.UsbRequested -> run { findBoard() }
            MicrobitSendEvent.OtherBoardRequested -> run { askForBoard() }
            is MicrobitSendEvent.BoardChosen -> run { usb.connect(event.board, sending()) }
            MicrobitSendEvent.Confirmed -> run { usb.send(sending()) }
            MicrobitSendEvent.WholeRequested -> run { usb.sendWhole(sending()) }
            MicrobitSendEvent.Retried -> run { retry() }
            MicrobitSendEvent.BackRequested -> run { showTransfers() }
            is MicrobitSendEvent.NumberEntered -> enterNumber(event.text)
            MicrobitSendEvent.LineShown -> showLine()
            MicrobitSendEvent.Cancelled -> cancel()
        }
    }

    /** Cancels whatever is under way and releases the board. */
    fun close() {
        if (state == null) return
        state = null
        work?.cancel()
        // Behind the work, which may just have connected it.
        scope.launch { oneAtATime.withLock { if (state == null) usb.close() } }
    }

    private fun begin() {
        state = MicrobitSendState(current.shownProgram.name, MicrobitSendStep.Building)
        run { build() }
    }

    private suspend fun build() {
        built = null
        when (val result = orNull { programs.build(current.shownProgram) }) {
            is MicrobitTranslation.Failure -> show(MicrobitSendStep.HasErrors(result.diagnostics.first()))

            MicrobitTranslation.NotForBoards, null -> show(MicrobitSendStep.CompilerFailed)

            is MicrobitTranslation.Success -> {
                built = result
                microPython.read()
                showTransfers()
            }
        }
    }

    /** Null if the translator crashes on the program because of a bug, which must not take the app with it. */
    private suspend fun <T> orNull(translate: suspend () -> T): T? = try {
        translate()
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (_: Throwable) {
        null
    }

    private suspend fun showTransfers(problem: ChoosingProblem? = null) {
        val built = built ?: return build()
        val file = microPython.chosen?.file
        state = state?.copy(microPython = microPython.chosen?.found, size = sizeOf(file, built))
        val mistake = file?.let { mistakeOf(it, built) }
        val transfers = transfers(built, hasFile = file != null && mistake == null)
        show(MicrobitSendStep.Choosing(transfers, problem ?: mistake?.let { ChoosingProblem.OfProgram(it) }))
    }

    /** @param hasFile whether there is MicroPython that takes the program; a board may have another one. */
    private fun transfers(built: MicrobitTranslation.Success, hasFile: Boolean): Set<MicrobitTransfer> = buildSet {
        if (platform.microbits.canReach && built.bytes.size <= built.maxBytes) add(MicrobitTransfer.USB)
        if (hasFile) {
            if (platform.microbitDrives.canWrite) add(MicrobitTransfer.DRIVE)
            add(MicrobitTransfer.SAVE)
        }
    }

    private suspend fun chooseMicroPython() = when (val result = microPython.choose()) {
        ChoosingResult.Cancelled -> Unit
        is ChoosingResult.Failure -> showTransfers(ChoosingProblem.OfFile(result.file, result.error))
        is ChoosingResult.Success -> showTransfers(ChoosingProblem.NotKept.takeIf { !result.isKept })
    }

    private suspend fun saveHex() {
        val built = built ?: return
        val hex = microPython.hexWith(built) ?: return showTransfers()
        val saved = platform.saveHex(current.shownProgram.name, hex)
        show(saved) { MicrobitSendStep.HexSaved(it) }
    }

    private suspend fun savePython() {
        val built = built ?: return
        show(platform.saveMain(built)) { MicrobitSendStep.PythonSaved(it) }
    }

    private suspend fun show(saved: SavedFile, next: (String) -> MicrobitSendStep) = when (saved) {
        is SavedFile.Success -> show(next(saved.name))
        SavedFile.Failure -> showTransfers(ChoosingProblem.NotSaved)
        SavedFile.Cancelled -> Unit
    }

    private suspend fun copyToDrive() {
        val hex = built?.let { microPython.hexWith(it) } ?: return showTransfers()
        val drives = platform.microbitDrives.available()
        val drive = drives.singleOrNull()
            ?: return showTransfers(if (drives.isEmpty()) ChoosingProblem.NoBoard else ChoosingProblem.SeveralBoards)
        show(MicrobitSendStep.Copying)
        when (val copied = platform.microbitDrives.copy(hex, drive)) {
            DriveResult.Copied -> show(MicrobitSendStep.Copied)
            is DriveResult.Refused -> show(MicrobitSendStep.NotCopied(copied.words))
            DriveResult.NotWritten -> show(MicrobitSendStep.NotCopied(words = ""))
        }
    }

    private suspend fun findBoard() {
        show(MicrobitSendStep.Looking)
        val boards = platform.microbits.available()
        val known = boards.firstOrNull { it == usb.lastUsed } ?: boards.singleOrNull()
        when {
            known != null -> usb.connect(known, sending())
            boards.isNotEmpty() -> show(MicrobitSendStep.ManyBoards(boards))
            else -> askForBoard()
        }
    }

    private suspend fun askForBoard() {
        show(MicrobitSendStep.Looking)
        when (val chosen = platform.microbits.choose()) {
            is ChosenBoard.Chosen -> usb.connect(chosen.board, sending())
            is ChosenBoard.Several -> show(MicrobitSendStep.ManyBoards(chosen.boards))
            is ChosenBoard.Refused -> show(MicrobitSendStep.Failed(chosen.error))
            ChosenBoard.None -> showTransfers(ChoosingProblem.NoBoard)
        }
    }

    private suspend fun retry() {
        val device = usb.device
        when {
            built == null -> build()
            device == null -> findBoard()
            // A board that was plugged in again may be another one for the platform.
            device !in platform.microbits.available() -> findBoard()
            else -> usb.connect(device, sending(), isKnown = true)
        }
    }

    private fun sending() = MicrobitSending(
        checkNotNull(built) {
            "The program was not built."
        },
        microPython.chosen?.file,
    )

    private fun enterNumber(text: String) {
        val step = state?.step as? MicrobitSendStep.HexSaved ?: return
        val number = text.filter(Char::isDigit).take(DISPLAYED_DIGITS)
        val kind = number.toIntOrNull()?.takeIf { number.length == DISPLAYED_DIGITS }?.let(FlashErrorKind::ofDisplay)
        show(step.copy(number = ShownNumber(number, kind)))
    }

    private fun showLine() {
        val shown = when (val step = state?.step) {
            is MicrobitSendStep.HasErrors -> step.first
            is MicrobitSendStep.Running -> step.errorLine?.let { errorAt(it) }
            else -> null
        } ?: return
        close()
        tabs.showDiagnostic(shown)
    }

    private fun errorAt(line: Int): Diagnostic {
        val file = current.shownProgram.files.first().name
        return Diagnostic(Severity.ERROR, file, SourceRange(line, column = 1, endColumn = 1), message = "")
    }

    private fun cancel() {
        val link = usb.link
        if (state?.step is MicrobitSendStep.Sending && link != null) {
            // What the board has is known only once the stream is closed.
            run { show(MicrobitSendStep.Cancelled(link.state.value.holds)) }
        } else {
            close()
        }
    }

    private fun show(step: MicrobitSendStep) {
        state = state?.copy(step = step)
    }

    /** Cancels the work before, and does [next] once that has ended. */
    private fun run(next: suspend () -> Unit) {
        work?.cancel()
        work = scope.launch { oneAtATime.withLock { next() } }
    }

    private companion object {
        /** A board shows 501 to 537. */
        const val DISPLAYED_DIGITS = 3
    }
}
