package robotran.hub

import robotran.hub.model.HubButton
import robotran.hub.model.HubColor
import robotran.hub.model.HubDeviceKind
import robotran.hub.model.HubPort
import robotran.hub.program.HubCall
import robotran.hub.program.HubNative
import kotlin.test.Test
import kotlin.test.assertEquals

/** The form of a call in the log is what other parts of Robotran compare programs by. */
class HubCallTest {
    @Test
    fun `calls are written as a Pybricks program asks for them`() {
        val told = listOf(
            HubCall.device(HubDeviceKind.MOTOR, HubPort.A, isReversed = true),
            HubCall.device(HubDeviceKind.MOTOR, HubPort.C),
            HubCall.device(HubDeviceKind.TOUCH_SENSOR, HubPort.S1),
            HubCall.driveBase(HubPort.A, HubPort.B, wheel = 49_600, track = 112_000),
            HubCall.of(HubNative.DRIVE_BASE_SETTINGS, 176, 166),
            HubCall.of(HubNative.DRIVE_BASE_STRAIGHT, -100),
            HubCall.of(HubNative.DRIVE_BASE_TURN, 90),
            HubCall.of(HubNative.DRIVE_BASE_DRIVE, 195, 0),
            HubCall.of(HubNative.DRIVE_BASE_BRAKE),
            HubCall.on(HubNative.MOTOR_RUN, HubPort.B, -360),
            HubCall.on(HubNative.MOTOR_RUN_ANGLE, HubPort.A, 360, 90, 1),
            HubCall.on(HubNative.MOTOR_RUN_TARGET, HubPort.C, 300, 90, 0),
            HubCall.on(HubNative.MOTOR_STOP, HubPort.C),
            HubCall.on(HubNative.MOTOR_RESET_ANGLE, HubPort.C, 0),
            HubCall.of(HubNative.SPEAKER_BEEP, 500, 100),
            HubCall.of(HubNative.DISPLAY_NUMBER, -7),
            HubCall.of(HubNative.DISPLAY_TEXT, "OK"),
            HubCall.of(HubNative.DISPLAY_OFF),
            HubCall.of(HubNative.SCREEN_PRINT, "1.5"),
            HubCall.of(HubNative.LIGHT_ON, HubColor.RED.ordinal),
            HubCall.of(HubNative.PRINT, "12"),
            HubCall.of(HubNative.SET_STOP_BUTTON, HubButton.BLUETOOTH.ordinal),
            HubCall.of(HubNative.SET_STOP_BUTTON, -1),
            HubCall.detectableColors(HubPort.D, listOf(HubColor.RED, HubColor.BLACK)),
        ).joinToString("\n")
        assertEquals(
            """
            device Motor A counterclockwise
            device Motor C
            device TouchSensor S1
            drive_base create 49.6 112
            drive_base settings 176 166
            drive_base straight -100
            drive_base turn 90
            drive_base drive 195 0
            drive_base brake
            motor B run -360
            motor A run_angle 360 90 nowait
            motor C run_target 300 90
            motor C stop
            motor C reset_angle 0
            speaker beep 500 100
            display number -7
            display text "OK"
            display off
            screen print "1.5"
            light on RED
            print "12"
            system set_stop_button BLUETOOTH
            system set_stop_button none
            sensor D detectable_colors RED,BLACK
            """.trimIndent(),
            told,
        )
    }

    @Test
    fun `ids of calls are unique`() {
        assertEquals(HubNative.entries.size, HubNative.entries.map { it.id }.distinct().size)
    }
}
