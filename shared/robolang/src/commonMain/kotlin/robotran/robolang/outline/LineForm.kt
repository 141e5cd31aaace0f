package robotran.robolang.outline

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

    END,
    ;

    /** Whether it begins a block that an `end` closes. */
    val isOpener: Boolean get() = this in OPENERS

    /** Whether it may stand only outside all blocks. */
    val isOutermost: Boolean get() = this in OUTERMOST

    private companion object {
        val OUTERMOST = setOf(PROCEDURE, FUNCTION, WHENEVER, ROBOT)
        val OPENERS =
            OUTERMOST + setOf(REPEAT, REPEAT_FOREVER, REPEAT_WHILE, REPEAT_UNTIL, FOR, FOR_WITH_STEP, FOR_EACH, IF)
    }
}
