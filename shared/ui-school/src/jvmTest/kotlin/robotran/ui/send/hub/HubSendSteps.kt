package robotran.ui.send.hub

import robotran.hublink.DownloadProgress
import robotran.hublink.HubError
import robotran.hublink.HubVersion
import robotran.hublink.Remains
import robotran.hublink.UnseenCause
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubTransport
import robotran.hublink.output.HubConsole
import robotran.hublink.output.ProgramError
import robotran.hublink.output.ProgramErrorKind
import robotran.language.source.Diagnostic
import robotran.language.source.Severity
import robotran.language.source.SourceRange
import robotran.workshop.state.FoundHub
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

internal val ADA = HubDevice("1", "Ada", HubTransport.BLUETOOTH)
internal val CABLE = HubDevice("2", "SPIKE Prime", HubTransport.USB_SERIAL)
internal val HUB = FoundHub("Ada", "SPIKE Prime", "4.0.1", room = 261_000)

private val ERRORS = listOf(
    HubError.OutOfReach,
    HubError.Taken,
    HubError.NotAllowed,
    HubError.BluetoothNotAllowed,
    HubError.LegoFirmware,
    HubError.TooOld(HubVersion(3, 1)),
    HubError.TooLarge(15_210, 13_788),
    HubError.NumberTooLarge("1073741824"),
    HubError.NotAProgram,
    HubError.Busy,
    HubError.DoesNotStop,
    HubError.NoProgram,
    HubError.BrokenOff,
    HubError.BadConnection,
    HubError.Refused(132),
)

private val LINES = listOf("pen down", "", "repeat 4 times", "  show distance", "end")

internal val PRINTED = HubConsole(List(40) { "distance ${it * 7}" }, unfinished = "dist", runningLine = 4)

/** One step of each kind, and each error, by a name for its picture. */
internal val HUB_STEPS: Map<String, HubSendState> = buildMap {
    fun put(name: String, step: HubSendStep, hub: FoundHub? = null) =
        put(name, HubSendState("square.robo", step, hub, lines = LINES))
    put("building", HubSendStep.Building)
    val mistake = Diagnostic(Severity.ERROR, "square.robo", SourceRange(12, 5, 9), "This hub has no sensor for sound.")
    put("mistake", HubSendStep.HasErrors(mistake))
    put("no-compiler", HubSendStep.NoCompiler)
    put("compiler-failed", HubSendStep.CompilerFailed)
    put("no-way", HubSendStep.NoWay())
    put("no-way-saved", HubSendStep.NoWay(savedAs = "square.py"))
    put("no-way-refused", HubSendStep.NoWay(isRefused = true))
    put("looking", HubSendStep.Looking)
    put("choose", HubSendStep.Choosing(emptyList(), HubTransport.entries))
    put("choose-one", HubSendStep.Choosing(listOf(ADA, CABLE), listOf(HubTransport.BLUETOOTH)))
    put("choose-last", HubSendStep.Choosing(listOf(CABLE, ADA), listOf(HubTransport.BLUETOOTH), last = CABLE))
    put("choose-missing", HubSendStep.Choosing(emptyList(), listOf(HubTransport.BLUETOOTH), isMissing = true))
    put("connecting", HubSendStep.Connecting)
    put("found", HubSendStep.Found, HUB)
    put("found-low", HubSendStep.Found, HUB.copy(isBatteryLow = true, isNewerThanKnown = true))
    put("found-other", HubSendStep.Found, HUB.copy(model = "Technic Hub", expected = "SPIKE Prime"))
    put("sending-begins", HubSendStep.Sending(null), HUB)
    put("sending", HubSendStep.Sending(DownloadProgress(1_504, 2_380, attempt = 1)), HUB)
    put("sending-again", HubSendStep.Sending(DownloadProgress(504, 2_380, attempt = 2)), HUB)
    put("cancelled", HubSendStep.Cancelled, HUB)
    put("ready", HubSendStep.Ready(2_380), HUB)
    put("ready-alone", HubSendStep.Ready(2_380, isGone = true), HUB)
    put("running", HubSendStep.Running(HubConsole()), HUB)
    put("running-prints", HubSendStep.Running(PRINTED), HUB)
    put("stopping", HubSendStep.Running(PRINTED, isStopping = true), HUB)
    put("ended", HubSendStep.Ended(HubConsole(listOf("20"))), HUB)
    put("stopped", HubSendStep.Ended(PRINTED.copy(wasStopped = true)), HUB)
    put("lost", HubSendStep.Ended(HubConsole(listOf("20")), isGone = true), HUB)
    for (kind in ProgramErrorKind.entries) {
        val error = ProgramError(kind, line = 7, port = "D", python = "ValueError: no")
        put("ended-${kind.name.lowercase()}", HubSendStep.Ended(HubConsole(listOf("Traceback"), error = error)), HUB)
    }
    put("error-notseen", HubSendStep.Failed(HubError.NotSeen(UnseenCause.entries)))
    put("error-left", HubSendStep.Failed(HubError.BrokenOff, Remains.NO_PROGRAM), HUB)
    for (error in ERRORS) put("error-${error::class.simpleName?.lowercase()}", HubSendStep.Failed(error), HUB)
}
