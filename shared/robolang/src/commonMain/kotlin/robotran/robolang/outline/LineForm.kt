package robotran.robolang.outline

import robotran.brick.kind.BrickKind

/** What a line of Robolang says. The forms of one keyword differ in the values that they take. */
enum class LineForm {
    /** `forward 20`, `backward 20`, in centimetres. */
    MOVE,

    /** `forward for 2 seconds`. */
    MOVE_FOR_TIME,

    /** `turn left 90`, in degrees. */
    TURN,

    /** `turn left for 1 second`. */
    TURN_FOR_TIME,

    START_MOVING,

    START_TURNING,

    STOP,

    /** `power 5`, both wheels. */
    POWER,

    /** `power left 5`. */
    POWER_OF_SIDE,

    /** `motor A forward`. */
    MOTOR,

    /** `motor A power 5`. */
    POWER_OF_MOTOR,

    /** `motor A turn 90`, in degrees. */
    MOTOR_TURN,

    /** `start motor A turn 90`. */
    START_MOTOR_TURN,

    RESET_MOTOR,

    PEN,

    WAIT,

    WAIT_UNTIL,

    RESET_TIMER,

    BEEP,

    BUZZ,

    PLAY,

    SHOW,

    /** `show "HELLO"`. */
    SHOW_TEXT,

    CLEAR_SCREEN,

    /** `repeat 4 times`. */
    REPEAT,

    REPEAT_FOREVER,

    REPEAT_WHILE,

    REPEAT_UNTIL,

    FOR,

    /** `for i from 0 to 10 step 2`. */
    FOR_WITH_STEP,

    FOR_EACH,

    BREAK,

    CONTINUE,

    IF,

    ELSE_IF,

    ELSE,

    HALT,

    DECLARE_VARIABLE,

    DECLARE_CONSTANT,

    ASSIGN,

    /** `list[0] = 5`. */
    ASSIGN_ELEMENT,

    PROCEDURE,

    FUNCTION,

    CALL,

    RETURN,

    RETURN_VALUE,

    WHENEVER,

    ROBOT,

    /** `light sensor on 2 facing down`, in the header. */
    LIGHT_SENSOR,

    /** `brick nxt`, in the header. */
    BRICK,

    /** `sonar on 4`, in the header. */
    SONAR,

    /** `colour sensor on 3`, in the header. */
    COLOUR_SENSOR,

    /** `sound sensor on 2`, in the header. */
    SOUND_SENSOR,

    END,
    ;

    /** Whether it begins a block that an `end` closes. */
    val isOpener: Boolean get() = this in OPENERS

    /** Whether it may stand only outside all blocks. */
    val isOutermost: Boolean get() = this in OUTERMOST

    /** Whether it may stand only in the header. */
    val isSetting: Boolean get() = this in SETTINGS

    /** The only brick that it is for; null for both. */
    val brick: BrickKind? get() = if (this in FOR_NXT) BrickKind.NXT else null

    private companion object {
        val SETTINGS = setOf(LIGHT_SENSOR, BRICK, SONAR, COLOUR_SENSOR, SOUND_SENSOR)
        val FOR_NXT = setOf(MOTOR_TURN, START_MOTOR_TURN, RESET_MOTOR, SONAR, COLOUR_SENSOR, SOUND_SENSOR)
        val OUTERMOST = setOf(PROCEDURE, FUNCTION, WHENEVER, ROBOT)
        val OPENERS =
            OUTERMOST + setOf(REPEAT, REPEAT_FOREVER, REPEAT_WHILE, REPEAT_UNTIL, FOR, FOR_WITH_STEP, FOR_EACH, IF)
    }
}
