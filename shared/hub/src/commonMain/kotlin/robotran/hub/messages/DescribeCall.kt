package robotran.hub.messages

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative
import robotran.language.quoted
import kotlin.math.abs

/** What [call] did, in words. */
internal fun HubMessages.describe(call: HubCall): String {
    val n = call.numbers
    val port = call.port?.name.orEmpty()
    val text = quoted(call.text.orEmpty())
    return when (call.native) {
        HubNative.DEVICE -> device(port, isReversed = n[2] != 0)
        HubNative.DRIVE_BASE_CREATE -> driveBase()
        HubNative.DRIVE_BASE_SETTINGS -> driveSpeeds(n[0], n[1])
        HubNative.DRIVE_BASE_STRAIGHT -> straight(abs(n[0]), isBackward = n[0] < 0)
        HubNative.DRIVE_BASE_TURN -> turn(abs(n[0]), isLeft = n[0] < 0)
        HubNative.DRIVE_BASE_DRIVE -> drive(n[0], n[1])
        HubNative.DRIVE_BASE_BRAKE -> driveBrake()
        HubNative.DRIVE_BASE_STOP -> driveRoll()
        HubNative.MOTOR_RUN -> motorRun(port, abs(n[1]), isBackward = n[1] < 0)
        HubNative.MOTOR_RUN_ANGLE -> motorTurn(port, n[2], n[1])
        HubNative.MOTOR_RUN_TARGET -> motorTarget(port, n[2], n[1])
        HubNative.MOTOR_BRAKE -> motorBrake(port)
        HubNative.MOTOR_STOP -> motorRoll(port)
        HubNative.MOTOR_HOLD -> motorHold(port)
        HubNative.MOTOR_RESET_ANGLE -> motorReset(port, n[1])
        HubNative.SPEAKER_BEEP -> tone(n[0], n[1])
        HubNative.DISPLAY_NUMBER -> show("${n[0]}")
        HubNative.DISPLAY_TEXT, HubNative.DISPLAY_CHAR, HubNative.SCREEN_PRINT -> show(text)
        HubNative.DISPLAY_OFF, HubNative.SCREEN_CLEAR -> clear()
        HubNative.LIGHT_ON -> lightOn(HubColor.entries.getOrElse(n[0]) { HubColor.NONE }.name)
        HubNative.LIGHT_OFF -> lightOff()
        HubNative.PRINT -> printed(text)
        HubNative.SET_STOP_BUTTON -> stopButton(HubButton.entries.getOrNull(n[0])?.name)
        HubNative.DETECTABLE_COLORS -> colors(port, call.colors.map { it.name })
    }
}

/** Why a program ends whose [call] the hub refuses, in a sentence. */
fun HubErrorMessages.reason(error: HubError, call: HubCall): String = when (error) {
    HubError.NO_DEVICE -> noDevice(call.port?.name.orEmpty(), isMotor = call.numbers.getOrNull(1) == 0)
    HubError.BUSY -> busy(call.port?.name.orEmpty())
    HubError.WRONG_DEVICE -> wrongDevice(call.port?.name.orEmpty())
    HubError.INVALID_ARGUMENT -> invalidArgument()
    HubError.NO_SUCH_PART -> noSuchPart()
}
