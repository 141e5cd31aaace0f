package robotran.workshop.send

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withTimeoutOrNull
import robotran.documents.FileKind
import robotran.hublink.DownloadResult
import robotran.hublink.HubError
import robotran.hublink.HubResult
import robotran.hublink.Remains
import robotran.hublink.connection.ChosenHub
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.hub.HubLink
import robotran.hublink.hub.HubState
import robotran.hublink.output.HubConsole
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.robolang.python.PythonTranslation
import robotran.workshop.event.HubSendEvent
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Saving
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProgramTabs
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep
import kotlin.coroutines.cancellation.CancellationException
import kotlin.time.Duration.Companion.seconds

/**
 * Sends the shown program to a real hub, step by step, and tells what it does there. One piece of work runs at a time. The
 * hub stays connected until the sheet is closed or another hub is chosen; its program then goes on.
 */
internal class HubSendStateHolder(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val current: CurrentProject,
    private val tabs: ProgramTabs,
    private val programs: HubProgramBuilder,
) {
    /** Null while the sheet is closed. */
    var state: HubSendState? by mutableStateOf(null)
        private set

    private val oneAtATime = Mutex()
    private var work: Job? = null
    private var python: PythonTranslation? = null

    /** [python] with what tells which line runs. */
    private var telling: PythonTranslation? = null
    private var tellsLine = true
    private var built: HubBuildResult.Success? = null
    private val memory = HubMemory(platform.store)
    private val session by lazy(LazyThreadSafetyMode.NONE) { HubSession(platform.hubs, scope) }

    fun handle(event: HubSendEvent) {
        if (event != HubSendEvent.Requested && state == null) return
        when (event) {
            HubSendEvent.Requested -> if (state == null) begin()
            is HubSendEvent.TransportRequested -> run { ask(event.transport) }
            is HubSendEvent.HubChosen -> run { connect(event.device) }
            HubSendEvent.OtherHubRequested -> run { lookForHubs(findsAlone = false) }
            HubSendEvent.Confirmed -> run { send() }
            is HubSendEvent.LineSwitched -> run { switchLine(event.isOn) }
            HubSendEvent.Retried -> run { retry() }
            HubSendEvent.Started -> run { start() }
            HubSendEvent.Stopped -> run { stop() }
            HubSendEvent.PythonSaved -> run { savePython() }
            HubSendEvent.LineShown -> showLine()
            HubSendEvent.Cancelled -> cancel()
        }
    }

    /** Cancels whatever is under way and releases the hub. */
    fun close() {
        if (state == null) return
        state = null
        work?.cancel()
        // Behind the work, which may just have connected it.
        scope.launch { oneAtATime.withLock { if (state == null) session.close() } }
    }

    private fun begin() {
        val program = current.shownProgram
        val lines = program.text.lines()
        state = HubSendState(program.name, HubSendStep.Building, tellsLine = tellsLine, lines = lines)
        run { build() }
    }

    private suspend fun build() {
        show(HubSendStep.Building)
        // Until it is built, no try may send what was built before.
        python = null
        telling = null
        built = null
        when (val translated = orNull { programs.translate(current.shownProgram) }) {
            is HubTranslation.Failure -> show(HubSendStep.HasErrors(translated.diagnostics.first()))

            HubTranslation.NotForHubs, null -> show(HubSendStep.CompilerFailed)

            is HubTranslation.Success -> {
                python = translated.python
                telling = translated.telling
                if (platform.hubs.transports.isEmpty()) {
                    show(HubSendStep.NoWay())
                } else {
                    compile { lookForHubs(findsAlone = true) }
                }
            }
        }
    }

    /** Null if a compiler crashes on the program because of a bug, which must not take the app with it. */
    private suspend fun <T> orNull(compile: suspend () -> T): T? = try {
        compile()
    } catch (cancelled: CancellationException) {
        throw cancelled
    } catch (_: Throwable) {
        null
    }

    /** Compiles the translation and goes on with [next]. */
    private suspend fun compile(next: suspend () -> Unit) {
        val python = (if (state?.tellsLine == true) telling else python) ?: return build()
        when (val result = orNull { programs.compile(python) }) {
            HubBuildResult.NoCompiler -> show(HubSendStep.NoCompiler)

            HubBuildResult.CompilerFailed, null -> show(HubSendStep.CompilerFailed)

            is HubBuildResult.Success -> {
                built = result
                // No hub takes it, so nobody needs to look for one.
                val mistake = result.program.mistake()
                if (mistake == null) next() else fail(mistake)
            }
        }
    }

    /** Compiles the program so that it tells which line runs, or does not; then it can be sent. */
    private suspend fun switchLine(isOn: Boolean) {
        val step = state?.step
        if (step !is HubSendStep.Found && step !is HubSendStep.Ready) return
        tellsLine = isOn
        state = state?.copy(tellsLine = isOn)
        // What was sent before is another program.
        compile { show(HubSendStep.Found) }
    }

    /** @param findsAlone whether the hub that was used last, or the only one at a cable, is taken without asking. */
    private suspend fun lookForHubs(findsAlone: Boolean) {
        val last = session.lastUsed
        if (findsAlone && last != null) return connect(last)
        session.close()
        show(HubSendStep.Looking)
        val devices = platform.hubs.available()
        // Over Bluetooth, the only hub may be that of another pupil.
        val alone = devices.singleOrNull()?.takeIf { it.transport != HubTransport.BLUETOOTH }
        if (findsAlone && alone != null) return connect(alone)
        choose(devices)
    }

    /** Shows [devices], the one that was used last first. */
    private suspend fun choose(devices: List<HubDevice>, isMissing: Boolean = false) {
        val last = memory.lastOf(devices)
        show(HubSendStep.Choosing(listOfNotNull(last) + (devices - setOfNotNull(last)), transports(), isMissing, last))
    }

    private suspend fun ask(transport: HubTransport) {
        show(HubSendStep.Looking)
        when (val chosen = platform.hubs.choose(transport)) {
            is ChosenHub.Chosen -> connect(chosen.device)
            is ChosenHub.Refused -> fail(chosen.error)
            ChosenHub.None -> platform.hubs.available().let { choose(it, isMissing = it.isEmpty()) }
        }
    }

    /** Connects [device] unless it is connected, and sends the program if the pupil knows the hub. */
    private suspend fun connect(device: HubDevice) {
        show(HubSendStep.Connecting)
        val isKnown = device == session.lastUsed
        session.open(device)?.let { return fail(it) }
        memory.remember(device)
        val hub = session.link?.let { foundHub(it.state.value, current.shownRobot.description.brick) }
        state = state?.copy(hub = hub)
        if (isKnown && hub?.expected == null) send() else show(HubSendStep.Found)
    }

    private suspend fun send() {
        val program = built ?: return build()
        val link = session.link ?: return retry()
        show(HubSendStep.Sending(null))
        when (val result = link.send(program.program) { show(HubSendStep.Sending(it)) }) {
            is DownloadResult.Failure -> if (state?.tellsLine == true && result.error is HubError.TooLarge) {
                // Without what tells the lines it may have room. The next program begins with the pupil's choice again.
                state = state?.copy(tellsLine = false)
                compile { send() }
            } else {
                fail(result.error, result.remains)
            }

            is DownloadResult.Success -> {
                link.expectProgram(program.map)
                show(HubSendStep.Ready(result.bytes))
                follow(link)
            }
        }
    }

    private suspend fun start() {
        val link = session.link ?: return retry()
        when (val result = link.start(built?.map)) {
            is HubResult.Failure -> fail(result.error)

            is HubResult.Success -> {
                show(HubSendStep.Running(HubConsole()))
                // The hub tells a moment later that it runs, or not at all if the program ends at once.
                withTimeoutOrNull(START) { link.state.first { it.isProgramRunning || it.isGone || it.hasPrinted } }
                follow(link)
            }
        }
    }

    private suspend fun stop() {
        val link = session.link ?: return retry()
        show(HubSendStep.Running(link.state.value.console, isStopping = true))
        when (val result = link.stop()) {
            is HubResult.Failure -> fail(result.error)
            is HubResult.Success -> follow(link)
        }
    }

    /** Shows what the program does, which somebody may also start and stop at the hub, until the hub is gone. */
    private suspend fun follow(link: HubLink) {
        link.state.first { hub ->
            state?.step?.after(hub)?.let(::show)
            hub.isGone
        }
        session.close()
    }

    private suspend fun savePython() {
        val step = state?.step as? HubSendStep.NoWay ?: return
        val python = python ?: return
        when (val saving = platform.files.save(python.fileName, FileKind.PYTHON, python.python.encodeToByteArray())) {
            is Saving.Saved -> show(HubSendStep.NoWay(saving.name))
            is Saving.Failed -> show(step.copy(isRefused = true))
            Saving.Cancelled -> Unit
        }
    }

    private suspend fun fail(error: HubError, remains: Remains = Remains.AS_BEFORE) {
        if (session.link?.state?.value?.isGone == true) session.close()
        show(HubSendStep.Failed(error, remains))
    }

    private suspend fun retry() {
        val device = session.device
        when {
            built == null -> build()
            device == null -> lookForHubs(findsAlone = true)
            else -> connect(device)
        }
    }

    private fun showLine() {
        val shown = when (val step = state?.step) {
            is HubSendStep.HasErrors -> step.first
            is HubSendStep.Ended -> step.console.error?.line?.let { errorAt(it) }
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
        if (state?.step is HubSendStep.Sending) run { show(HubSendStep.Cancelled) } else close()
    }

    private fun transports() = HubTransport.entries.filter { it in platform.hubs.transports }

    private fun show(step: HubSendStep) {
        state = state?.copy(step = step)
    }

    /** Cancels the work before, and does [next] once that has ended. */
    private fun run(next: suspend () -> Unit) {
        work?.cancel()
        work = scope.launch { oneAtATime.withLock { next() } }
    }

    private companion object {
        val START = 1.seconds
    }
}

/** What follows this step of a program that was sent, once the hub is in the state [hub]; null if nothing does. */
private fun HubSendStep.after(hub: HubState): HubSendStep? = when {
    this is HubSendStep.Ready && hub.isGone -> copy(isGone = true)
    this is HubSendStep.Ready && !hub.isProgramRunning && !hub.hasPrinted -> null
    hub.isGone -> HubSendStep.Ended(hub.console, isGone = this is HubSendStep.Running)
    hub.isProgramRunning -> HubSendStep.Running(hub.console)
    else -> HubSendStep.Ended(hub.console)
}

private val HubState.hasPrinted get() = console != HubConsole()
