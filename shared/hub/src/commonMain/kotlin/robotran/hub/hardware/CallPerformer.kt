package robotran.hub.hardware

import robotran.hub.control.DriveBase
import robotran.hub.control.HubMotor
import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubCall
import robotran.hub.program.HubError
import robotran.hub.program.HubNative

/** Does what the calls of a program say. Returns why it does not; null if it did. */
internal class CallPerformer(private val hardware: HubHardware) {
    fun perform(call: HubCall): HubError? {
        if (call.numbers.size < call.native.parameters) return HubError.INVALID_ARGUMENT
        val n = call.numbers
        return when (call.native) {
            HubNative.DEVICE -> makeDevice(call)

            HubNative.DRIVE_BASE_CREATE -> makeDriveBase(n)

            HubNative.DRIVE_BASE_SETTINGS, HubNative.DRIVE_BASE_STRAIGHT, HubNative.DRIVE_BASE_TURN,
            HubNative.DRIVE_BASE_DRIVE, HubNative.DRIVE_BASE_BRAKE, HubNative.DRIVE_BASE_STOP,
            -> drive(call, hardware.driveBase ?: return HubError.NO_DEVICE)

            HubNative.MOTOR_RUN, HubNative.MOTOR_RUN_ANGLE, HubNative.MOTOR_RUN_TARGET, HubNative.MOTOR_BRAKE,
            HubNative.MOTOR_STOP, HubNative.MOTOR_HOLD, HubNative.MOTOR_RESET_ANGLE,
            -> {
                val motor = call.port?.let(hardware::motor)?.takeIf { it.isMade }
                if (motor == null) HubError.NO_DEVICE else done { turn(call, motor) }
            }

            HubNative.SPEAKER_BEEP -> part(hardware.model.hasSpeaker) { hardware.speaker.beep(n[0], n[1]) }

            HubNative.DISPLAY_NUMBER, HubNative.DISPLAY_TEXT, HubNative.DISPLAY_CHAR, HubNative.DISPLAY_OFF ->
                if (hardware.model.hasMatrix) light(call) else HubError.NO_SUCH_PART

            HubNative.SCREEN_PRINT -> part(hardware.model.hasScreen) { hardware.display.printRow(call.text.orEmpty()) }
            HubNative.SCREEN_CLEAR -> part(hardware.model.hasScreen) { hardware.display.clearRows() }
            HubNative.LIGHT_ON -> lightOn(n[0])
            HubNative.LIGHT_OFF -> part(hardware.model.lights.isNotEmpty()) { hardware.light = HubColor.NONE }
            HubNative.PRINT -> done { hardware.display.print(call.text.orEmpty()) }
            HubNative.SET_STOP_BUTTON -> valid(hardware.buttons.setStopButton(HubButton.entries.getOrNull(n[0])))
            HubNative.DETECTABLE_COLORS -> detect(call)
        }
    }

    private fun makeDevice(call: HubCall): HubError? {
        val port = call.port ?: return HubError.INVALID_ARGUMENT
        val kind = HubDeviceKind.entries.getOrNull(call.numbers[1]) ?: return HubError.INVALID_ARGUMENT
        if (port !in hardware.model.ports) return HubError.INVALID_ARGUMENT
        val motor = hardware.motor(port)
        val sensor = hardware.inputs.kindOf(port)
        return when {
            motor?.isMade == true || hardware.inputs.isMade(port) -> HubError.BUSY
            motor?.plugged == null && sensor == null -> HubError.NO_DEVICE
            kind == HubDeviceKind.MOTOR -> makeMotor(motor, isReversed = call.numbers[2] != 0)
            sensor != kind -> HubError.WRONG_DEVICE
            else -> done { hardware.inputs.make(port, kind) }
        }
    }

    private fun makeMotor(motor: HubMotor?, isReversed: Boolean): HubError? {
        if (motor?.plugged == null) return HubError.WRONG_DEVICE
        motor.make(isReversed)
        return null
    }

    private fun makeDriveBase(n: IntArray): HubError? {
        val motors = n.take(2).map { number ->
            HubPort.entries.getOrNull(number)?.let(hardware::motor)?.takeIf { it.isMade }
        }
        val left = motors[0] ?: return HubError.NO_DEVICE
        val right = motors[1] ?: return HubError.NO_DEVICE
        if (left == right) return HubError.INVALID_ARGUMENT
        if (left.base != null || right.base != null) return HubError.BUSY
        val (wheel, track) = n[2] to n[TRACK]
        if (wheel < SMALLEST || track < SMALLEST) return HubError.INVALID_ARGUMENT
        hardware.driveBase = DriveBase(left, right, wheel, track)
        return null
    }

    private fun drive(call: HubCall, base: DriveBase): HubError? {
        val n = call.numbers
        return when (call.native) {
            HubNative.DRIVE_BASE_SETTINGS -> valid(base.set(n[0], n[1]))
            HubNative.DRIVE_BASE_STRAIGHT -> done { base.straight(n[0]) }
            HubNative.DRIVE_BASE_TURN -> done { base.turn(n[0]) }
            HubNative.DRIVE_BASE_DRIVE -> done { base.drive(n[0], n[1]) }
            HubNative.DRIVE_BASE_BRAKE -> done { base.brake() }
            else -> done { base.stop() }
        }
    }

    private fun turn(call: HubCall, motor: HubMotor) {
        val n = call.numbers
        when (call.native) {
            HubNative.MOTOR_RUN -> motor.run(n[1])
            HubNative.MOTOR_RUN_ANGLE -> motor.runBy(n[1], n[2])
            HubNative.MOTOR_RUN_TARGET -> motor.runTo(n[1], n[2].toDouble())
            HubNative.MOTOR_BRAKE -> motor.brake()
            HubNative.MOTOR_STOP -> motor.stop()
            HubNative.MOTOR_HOLD -> motor.hold()
            else -> motor.resetAngle(n[1])
        }
    }

    private fun light(call: HubCall): HubError? = when (call.native) {
        HubNative.DISPLAY_NUMBER -> done { hardware.display.showNumber(call.numbers[0]) }
        HubNative.DISPLAY_TEXT -> valid(hardware.display.showText(call.text.orEmpty()))
        HubNative.DISPLAY_CHAR -> valid(hardware.display.showCharacter(call.text.orEmpty()))
        else -> done { hardware.display.lightsOff() }
    }

    private fun lightOn(number: Int): HubError? {
        val color = HubColor.entries.getOrNull(number) ?: return HubError.INVALID_ARGUMENT
        return part(hardware.model.lights.isNotEmpty()) { hardware.light = color }
    }

    private fun detect(call: HubCall): HubError? {
        val port = call.port?.takeIf(hardware.inputs::isMade) ?: return HubError.NO_DEVICE
        return done { hardware.inputs.detect(port, call.colors) }
    }

    private fun valid(isValid: Boolean): HubError? = if (isValid) null else HubError.INVALID_ARGUMENT

    private inline fun part(has: Boolean, action: () -> Unit): HubError? =
        if (has) done(action) else HubError.NO_SUCH_PART

    private inline fun done(action: () -> Unit): HubError? {
        action()
        return null
    }

    private companion object {
        const val TRACK = 3

        /** A millimetre. */
        const val SMALLEST = 1_000
    }
}
