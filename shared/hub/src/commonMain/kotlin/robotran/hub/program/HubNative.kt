package robotran.hub.program

import robotran.brick.log.CallGroup

/**
 * The calls by which a program acts on a hub: what a Pybricks program asks of it. Ports, devices, colours and buttons are
 * the places of their entries in [robotran.hub.model.HubPort] and its like.
 *
 * @property id never changes, because it identifies a call in the trace of a run.
 * @property words how the log names it.
 * @property parameters how many numbers a call has, at least.
 */
enum class HubNative(val id: Int, val words: String, val group: CallGroup, val parameters: Int) {
    /** Port; kind of device; 1 if the motor turns the other way round. */
    DEVICE(1, "device", CallGroup.SENSORS, parameters = 3),

    /** Left motor; right motor; wheel diameter and axle track, thousandths of a millimetre. */
    DRIVE_BASE_CREATE(2, "drive_base create", CallGroup.MOTORS, parameters = 4),

    /** Straight speed, mm/s; turn rate, deg/s. */
    DRIVE_BASE_SETTINGS(3, "drive_base settings", CallGroup.MOTORS, parameters = 2),

    /** Millimetres. */
    DRIVE_BASE_STRAIGHT(4, "drive_base straight", CallGroup.MOTORS, parameters = 1),

    /** Degrees, to the right. */
    DRIVE_BASE_TURN(5, "drive_base turn", CallGroup.MOTORS, parameters = 1),

    /** mm/s; deg/s, to the right. */
    DRIVE_BASE_DRIVE(6, "drive_base drive", CallGroup.MOTORS, parameters = 2),
    DRIVE_BASE_BRAKE(7, "drive_base brake", CallGroup.MOTORS, parameters = 0),

    /** Both motors coast. */
    DRIVE_BASE_STOP(8, "drive_base stop", CallGroup.MOTORS, parameters = 0),

    /** Port; deg/s. */
    MOTOR_RUN(10, "run", CallGroup.MOTORS, parameters = 2),

    /** Port; deg/s; degrees; 1 if the program does not wait for it. */
    MOTOR_RUN_ANGLE(11, "run_angle", CallGroup.MOTORS, parameters = 4),

    /** Port; deg/s; degrees; 1 if the program does not wait for it. */
    MOTOR_RUN_TARGET(12, "run_target", CallGroup.MOTORS, parameters = 4),

    /** Port. */
    MOTOR_BRAKE(13, "brake", CallGroup.MOTORS, parameters = 1),

    /** Port. The motor coasts. */
    MOTOR_STOP(14, "stop", CallGroup.MOTORS, parameters = 1),

    /** Port. */
    MOTOR_HOLD(15, "hold", CallGroup.MOTORS, parameters = 1),

    /** Port; degrees. */
    MOTOR_RESET_ANGLE(16, "reset_angle", CallGroup.MOTORS, parameters = 2),

    /** Hertz; milliseconds. */
    SPEAKER_BEEP(20, "speaker beep", CallGroup.SOUND, parameters = 2),

    /** Number. */
    DISPLAY_NUMBER(21, "display number", CallGroup.DISPLAY, parameters = 1),

    /** Text, a letter after the other. */
    DISPLAY_TEXT(22, "display text", CallGroup.DISPLAY, parameters = 0),

    /** A text of one character. */
    DISPLAY_CHAR(23, "display char", CallGroup.DISPLAY, parameters = 0),
    DISPLAY_OFF(24, "display off", CallGroup.DISPLAY, parameters = 0),

    /** Text, a row of the screen. */
    SCREEN_PRINT(25, "screen print", CallGroup.DISPLAY, parameters = 0),
    SCREEN_CLEAR(26, "screen clear", CallGroup.DISPLAY, parameters = 0),

    /** Colour. */
    LIGHT_ON(27, "light on", CallGroup.DISPLAY, parameters = 1),
    LIGHT_OFF(28, "light off", CallGroup.DISPLAY, parameters = 0),

    /** Text, a line of the output. */
    PRINT(30, "print", CallGroup.SYSTEM, parameters = 0),

    /** Button; -1 for none. */
    SET_STOP_BUTTON(31, "system set_stop_button", CallGroup.BUTTONS, parameters = 1),

    /** Port; colours. */
    DETECTABLE_COLORS(32, "detectable_colors", CallGroup.SENSORS, parameters = 1),
}
