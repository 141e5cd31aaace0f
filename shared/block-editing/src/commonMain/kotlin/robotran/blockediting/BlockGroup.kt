package robotran.blockediting

import robotran.robolang.outline.LineForm
import robotran.robolang.outline.ValueForm

/** The groups of blocks. The palette has a page for each; a group also has its own colour and sign. */
enum class BlockGroup { DRIVE, PEN, SENSE, CONTROL, NUMBERS, LISTS, OWN_COMMANDS, SHOW_AND_SOUND }

/** The group of a line or of the block that it begins. */
val LineForm.group: BlockGroup
    get() = when (this) {
        LineForm.MOVE, LineForm.MOVE_FOR_TIME, LineForm.TURN, LineForm.TURN_FOR_TIME, LineForm.START_MOVING,
        LineForm.START_TURNING, LineForm.STOP, LineForm.POWER, LineForm.POWER_OF_SIDE, LineForm.MOTOR,
        LineForm.POWER_OF_MOTOR, LineForm.MOTOR_TURN, LineForm.START_MOTOR_TURN,
        -> {
            BlockGroup.DRIVE
        }

        LineForm.PEN -> BlockGroup.PEN

        LineForm.RESET_TIMER, LineForm.RESET_MOTOR, LineForm.ROBOT, LineForm.LIGHT_SENSOR, LineForm.BRICK,
        LineForm.SONAR, LineForm.COLOUR_SENSOR, LineForm.SOUND_SENSOR,
        -> {
            BlockGroup.SENSE
        }

        LineForm.WAIT, LineForm.WAIT_UNTIL, LineForm.REPEAT, LineForm.REPEAT_FOREVER, LineForm.REPEAT_WHILE,
        LineForm.REPEAT_UNTIL, LineForm.FOR, LineForm.FOR_WITH_STEP, LineForm.BREAK, LineForm.CONTINUE,
        LineForm.IF, LineForm.ELSE_IF, LineForm.ELSE, LineForm.HALT, LineForm.WHENEVER, LineForm.END,
        -> {
            BlockGroup.CONTROL
        }

        LineForm.DECLARE_VARIABLE, LineForm.DECLARE_CONSTANT, LineForm.ASSIGN -> BlockGroup.NUMBERS
        LineForm.FOR_EACH, LineForm.ASSIGN_ELEMENT -> BlockGroup.LISTS

        LineForm.PROCEDURE, LineForm.FUNCTION, LineForm.CALL, LineForm.RETURN, LineForm.RETURN_VALUE -> {
            BlockGroup.OWN_COMMANDS
        }

        LineForm.BEEP, LineForm.BUZZ, LineForm.PLAY, LineForm.SHOW, LineForm.SHOW_TEXT, LineForm.CLEAR_SCREEN -> {
            BlockGroup.SHOW_AND_SOUND
        }
    }

/** The group of a value. */
val ValueForm.group: BlockGroup
    get() = when (this) {
        ValueForm.NUMBER, ValueForm.NAME, ValueForm.NEGATION, ValueForm.ARITHMETIC, ValueForm.BUILT_IN,
        ValueForm.BRACKETS,
        -> {
            BlockGroup.NUMBERS
        }

        ValueForm.TRUTH, ValueForm.NOT, ValueForm.LOGIC, ValueForm.COMPARISON -> BlockGroup.CONTROL
        ValueForm.LIST, ValueForm.ELEMENT -> BlockGroup.LISTS
        ValueForm.CALL -> BlockGroup.OWN_COMMANDS

        ValueForm.BUMPER, ValueForm.LIGHT, ValueForm.SENSOR, ValueForm.BUTTON, ValueForm.TIMER, ValueForm.BATTERY,
        ValueForm.DISTANCE, ValueForm.LOUDNESS, ValueForm.COLOUR, ValueForm.COLOUR_NAME, ValueForm.TURNED,
        -> {
            BlockGroup.SENSE
        }
    }
