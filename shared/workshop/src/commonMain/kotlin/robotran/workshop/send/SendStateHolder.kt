package robotran.workshop.send

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.NonCancellable
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.documents.FileKind
import robotran.legofirmware.device.csvOf
import robotran.tower.Remains
import robotran.tower.TowerError
import robotran.tower.TowerResult
import robotran.tower.TransferProgress
import robotran.tower.TransferResult
import robotran.tower.port.TowerDevice
import robotran.tower.port.TowerKind
import robotran.workshop.event.SendEvent
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramTabs
import robotran.workshop.state.ChosenFirmware
import robotran.workshop.state.SendError
import robotran.workshop.state.SendState
import robotran.workshop.state.SendStep
import robotran.workshop.state.Transfer

/**
 * Sends the shown program to a real robot, step by step. One piece of work runs at a time; each ends in a step that the
 * pupil sees. The tower stays open from the first check until the sheet is closed or another tower is chosen.
 */
class SendStateHolder(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val current: CurrentProject,
    private val tabs: ProgramTabs,
    private val images: ImageBuilder,
    robots: RobotLinks,
) {
    /** Null while the sheet is closed. */
    var state: SendState? by mutableStateOf(null)
        private set

    private var work: Job? = null
    private var program: BuiltProgram? = null

    /** The slot of LEGO's firmware that the pupil has chosen for this program; null for none yet. */
    private var slot: Int? = null

    /** The slot that was chosen for the program before. */
    private var lastSlot: Int? = null
    private var firmware: ChosenFirmware? = null

    /** Why the brick needs another firmware, when it was asked last. */
    private var why: TowerError = TowerError.NoLejos()
    private val connection = TowerConnection(platform.towers, robots)

    fun handle(event: SendEvent) {
        if (event != SendEvent.Requested && state == null) return
        when (event) {
            SendEvent.Requested -> if (state == null) begin()
            is SendEvent.TowerRequested -> run { ask(event.kind) }
            is SendEvent.TowerChosen -> run { use(event.device) }
            SendEvent.OtherTowerRequested -> run { lookForTowers(findsAlone = false) }
            SendEvent.Retried -> run { retry() }
            is SendEvent.SlotChosen -> run { sendInto(event.slot, emptiesOthers = false) }
            SendEvent.SlotsEmptied -> run { slot?.let { sendInto(it, emptiesOthers = true) } }
            SendEvent.DatalogRequested -> run { readDatalog() }
            SendEvent.DatalogSaved -> run { saveDatalog() }
            SendEvent.FirmwareFileRequested -> run { chooseFirmware() }
            SendEvent.FirmwareConfirmed -> run { sendFirmware() }
            SendEvent.DiagnosticShown -> showDiagnostic()
            SendEvent.WatchingRequested -> run { watch() }
            SendEvent.Cancelled -> cancel()
        }
    }

    /** Cancels whatever is under way and releases the tower. */
    fun close() {
        state = null
        val before = work
        work = null
        before?.cancel()
        val opened = connection.forget() ?: return
        scope.launch {
            before?.join()
            withContext(NonCancellable) { opened.close() }
        }
    }

    private fun begin() {
        state = SendState(current.shownProgram.name, SendStep.Building)
        run { build() }
    }

    private suspend fun build() {
        show(SendStep.Building)
        // Until it is built, no try may send what was built before.
        program = null
        slot = null
        when (val result = images.build(current.shownProgram)) {
            is ProgramImageResult.Failure -> show(SendStep.HasErrors(result.diagnostics.first()))
            ProgramImageResult.NoCompiler -> show(SendStep.NoCompiler)
            ProgramImageResult.CompilerFailed -> show(SendStep.CompilerFailed)

            is ProgramImageResult.Success -> {
                program = result.program
                lookForTowers(findsAlone = true)
            }
        }
    }

    /** @param findsAlone whether the only tower, or the one that was used last, is taken without asking. */
    private suspend fun lookForTowers(findsAlone: Boolean) {
        connection.close()
        val towers = platform.towers
        if (towers.kinds.isEmpty()) return show(SendStep.NoTowers)
        val devices = towers.available()
        val last = devices.firstOrNull { it.id == connection.device?.id }
        val found = last ?: devices.singleOrNull()
        if (findsAlone && found != null) return check(found, isKnown = last != null)
        show(SendStep.ChoosingTower(devices, kinds()))
    }

    private suspend fun ask(kind: TowerKind) {
        val chosen = platform.towers.choose(kind)
        if (chosen != null) return use(chosen)
        show(SendStep.ChoosingTower(platform.towers.available(), kinds(), isMissing = true))
    }

    private suspend fun use(device: TowerDevice) {
        connection.close()
        check(device)
    }

    private suspend fun check() = check(checkNotNull(connection.device) { "No tower was chosen." })

    /**
     * Opens the tower unless it is open, looks for a brick and sends the program.
     *
     * @param isKnown whether the pupil has chosen it; otherwise it may be any serial port of the machine.
     */
    private suspend fun check(device: TowerDevice, isKnown: Boolean = true) {
        show(SendStep.Checking)
        connection.open(device)?.let { return show(SendStep.Failed(SendError.OfPort(it.reason, device.kind))) }
        if (!isKnown && !link().isTowerThere()) return fail(TowerError.TowerSilent)
        val error = link().check(checkNotNull(program) { "The program was not built." })
        if (error == null) sendProgram() else fail(error)
    }

    private suspend fun sendProgram() = when (val program = checkNotNull(program) { "The program was not built." }) {
        is BuiltProgram.Lejos -> end(transfer(Transfer.PROGRAM) { link().sendProgram(program, it) })

        is BuiltProgram.Lego -> {
            slot?.let { sendInto(it, emptiesOthers = false) } ?: show(SendStep.ChoosingSlot(lastSlot))
        }
    }

    private suspend fun sendInto(slot: Int, emptiesOthers: Boolean) {
        val program = program as? BuiltProgram.Lego ?: return
        this.slot = slot
        lastSlot = slot
        // The tower may have been unplugged while the pupil was choosing.
        val link = connection.link ?: return check()
        val result = transfer(Transfer.PROGRAM) { link.sendProgram(program, slot, emptiesOthers, it) }
        end(result, failedSlot = slot.takeUnless { emptiesOthers })
    }

    /** @param failedSlot the only slot that may be changed if it has failed; null for leJOS, and if all are. */
    private suspend fun end(result: TransferResult, failedSlot: Int? = null) = when (result) {
        is TransferResult.Success -> show(SendStep.Done(result.bytes, slot))
        is TransferResult.Failure -> fail(result.error, result.remains, failedSlot)
    }

    private suspend fun sendFirmware() {
        val image = (state?.step as? SendStep.NeedsFirmware)?.usable ?: return
        when (val result = transfer(Transfer.FIRMWARE) { link().sendFirmware(image, it) }) {
            is TransferResult.Success -> check()
            is TransferResult.Failure -> fail(result.error, result.remains)
        }
    }

    private suspend fun transfer(what: Transfer, send: suspend ((TransferProgress) -> Unit) -> TransferResult) =
        show(SendStep.Sending(what, null)).let { send { show(SendStep.Sending(what, it)) } }

    private suspend fun chooseFirmware() {
        firmware = platform.files.chooseFirmware() ?: return
        show(SendStep.NeedsFirmware(firmware, why))
    }

    private suspend fun readDatalog() {
        val link = connection.link ?: return check()
        show(SendStep.ReadingDatalog(null))
        when (val read = link.readDatalog { show(SendStep.ReadingDatalog(it)) }) {
            is TowerResult.Success -> show(SendStep.Datalog(read.value))
            is TowerResult.Failure -> fail(read.error)
        }
    }

    private suspend fun saveDatalog() {
        val step = state?.step as? SendStep.Datalog ?: return
        val csv = csvOf(step.entries).encodeToByteArray()
        when (val saving = platform.files.save(DATALOG_NAME, FileKind.CSV, csv)) {
            is Saving.Saved -> show(SendStep.Datalog(step.entries, savedAs = saving.name))
            is Saving.Failed -> show(step.copy(isRefused = true))
            Saving.Cancelled -> Unit
        }
    }

    private suspend fun watch() {
        val messages = MessageList(platform.clock)
        show(SendStep.Watching(emptyList()))
        link().watch { show(SendStep.Watching(messages.add(it))) }
        connection.close()
        show(SendStep.Watching(messages.messages, isOver = true))
    }

    private suspend fun fail(error: TowerError, remains: Remains = Remains.AS_BEFORE, slot: Int? = null) {
        // The port of a tower that was unplugged is of no use any more.
        if (error == TowerError.TowerGone) connection.close()
        if (error.asksForFirmware) {
            why = error
            show(SendStep.NeedsFirmware(firmware, error))
        } else {
            show(SendStep.Failed(SendError.OfTower(error), remains, slot))
        }
    }

    private suspend fun retry() = when {
        program == null -> build()
        connection.device == null -> lookForTowers(findsAlone = true)
        else -> check()
    }

    private fun showDiagnostic() {
        val step = state?.step as? SendStep.HasErrors ?: return
        close()
        tabs.showDiagnostic(step.first)
    }

    private fun cancel() {
        val step = state?.step
        if (step !is SendStep.Sending) return close()
        run { show(SendStep.Cancelled(step.what, slot.takeIf { step.what == Transfer.PROGRAM })) }
    }

    private fun link(): RobotLink = checkNotNull(connection.link) { "The tower is not open." }

    private fun kinds() = TowerKind.entries.filter { it in platform.towers.kinds }

    private fun show(step: SendStep) {
        state = state?.copy(step = step)
    }

    /** Cancels the work before, waits until it has ended, and does [next]. */
    private fun run(next: suspend () -> Unit) {
        val before = work
        before?.cancel()
        work = scope.launch {
            before?.join()
            next()
        }
    }
}

/** Whether another firmware mends it. */
private val TowerError.asksForFirmware
    get() = this is TowerError.NoLejos || this == TowerError.NoLegoFirmware || this is TowerError.LegoFirmwareTooOld

private const val DATALOG_NAME = "datalog.csv"
