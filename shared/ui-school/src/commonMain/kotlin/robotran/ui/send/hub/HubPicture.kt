package robotran.ui.send.hub

import androidx.compose.ui.graphics.drawscope.DrawScope
import robotran.hublink.HubError
import robotran.hublink.UnseenCause
import robotran.hublink.output.ProgramErrorKind
import robotran.ui.send.drawError
import robotran.uikit.*
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

/** A small picture of what happens between app and hub, or of what to do. */
enum class HubPicture(val draw: DrawScope.(RobotranColours) -> Unit) {
    /** A program, and a line of it in red. */
    MISTAKE({ drawError(it) }),
    PROGRAM({ drawProgramToHub(it) }),

    /** A tablet that reaches no hub; its program becomes a file. */
    NO_WAY({ drawNoWay(it) }),
    SWITCH_ON({ drawSwitchOn(it) }),
    CONNECTED({ drawConnected(it) }),
    SENDING({ drawSendingToHub(it) }),
    READY({ drawReady(it) }),
    RUNNING({ drawRunning(it) }),
    STOPPED({ drawStopped() }),

    /** A hub whose program runs, so that it hides. */
    STOP_FIRST({ drawStopFirst(it) }),
    TOO_FAR({ drawTooFar(it) }),

    /** Another tablet has it. */
    TAKEN({ drawTaken(it) }),
    LOCKED({ drawHubLocked(it) }),
    WRONG_FIRMWARE({ drawWrongFirmwareOfHub(it) }),
    NO_ROOM({ drawNoRoomInHub(it) }),

    /** A plug beside its port. */
    PLUG_IN({ drawPlugInDevice(it) }),
}

internal fun hubPictureOf(state: HubSendState): HubPicture = when (val step = state.step) {
    HubSendStep.Building -> HubPicture.PROGRAM
    is HubSendStep.HasErrors, HubSendStep.NoCompiler, HubSendStep.CompilerFailed -> HubPicture.MISTAKE
    is HubSendStep.NoWay -> HubPicture.NO_WAY
    HubSendStep.Looking, is HubSendStep.Choosing -> HubPicture.SWITCH_ON
    HubSendStep.Connecting, is HubSendStep.Sending -> HubPicture.SENDING
    HubSendStep.Found -> if (state.hub?.expected == null) HubPicture.CONNECTED else HubPicture.WRONG_FIRMWARE
    HubSendStep.Cancelled -> HubPicture.STOPPED
    is HubSendStep.Ready -> HubPicture.READY
    is HubSendStep.Running -> HubPicture.RUNNING
    is HubSendStep.Ended -> pictureOf(step)
    is HubSendStep.Failed -> pictureOf(step.error)
}

private fun pictureOf(step: HubSendStep.Ended): HubPicture = when {
    step.isGone -> HubPicture.TOO_FAR
    step.console.error?.kind == ProgramErrorKind.MISSING_DEVICE -> HubPicture.PLUG_IN
    step.console.error != null -> HubPicture.MISTAKE
    else -> HubPicture.STOPPED
}

private fun pictureOf(error: HubError): HubPicture = when (error) {
    is HubError.NotSeen -> error.causes.firstOrNull()?.let { pictureOf(it) } ?: HubPicture.SWITCH_ON
    HubError.OutOfReach, HubError.BrokenOff, HubError.BadConnection -> HubPicture.TOO_FAR
    HubError.Taken -> HubPicture.TAKEN
    HubError.NotAllowed, HubError.BluetoothNotAllowed -> HubPicture.LOCKED
    HubError.LegoFirmware, is HubError.TooOld -> HubPicture.WRONG_FIRMWARE
    is HubError.TooLarge -> HubPicture.NO_ROOM
    is HubError.NumberTooLarge, HubError.NotAProgram -> HubPicture.MISTAKE
    HubError.Busy, HubError.DoesNotStop -> HubPicture.STOP_FIRST
    HubError.NoProgram, is HubError.Refused -> HubPicture.SWITCH_ON
}

private fun pictureOf(cause: UnseenCause): HubPicture = when (cause) {
    UnseenCause.OFF, UnseenCause.BLUETOOTH_OFF -> HubPicture.SWITCH_ON
    UnseenCause.PROGRAM_RUNS -> HubPicture.STOP_FIRST
    UnseenCause.TOO_FAR -> HubPicture.TOO_FAR
    UnseenCause.TAKEN -> HubPicture.TAKEN
    UnseenCause.LEGO_FIRMWARE -> HubPicture.WRONG_FIRMWARE
}
