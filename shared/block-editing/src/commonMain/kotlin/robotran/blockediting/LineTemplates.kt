package robotran.blockediting

import robotran.brick.kind.BrickKind
import robotran.robolang.outline.LineForm

/**
 * The lines of a new block of this form; null if the palette has none. Those that use names of the pupil's come from
 * the program, see [robotran.blockediting.palette.ownBlocks]. Numbers are those of the tutorial.
 */
internal val LineForm.template: String?
    get() = when (this) {
        LineForm.MOVE -> "forward 20"
        LineForm.MOVE_FOR_TIME -> "forward for 2 seconds"
        LineForm.TURN -> "turn left 90"
        LineForm.TURN_FOR_TIME -> "turn left for 1 second"
        LineForm.START_MOVING -> "start forward"
        LineForm.START_TURNING -> "start turning left"
        LineForm.STOP -> "stop"
        LineForm.POWER -> "power 5"
        LineForm.POWER_OF_SIDE -> "power left 5"
        LineForm.MOTOR -> "motor A forward"
        LineForm.POWER_OF_MOTOR -> "motor A power 5"
        LineForm.MOTOR_TURN -> "motor A turn 90"
        LineForm.START_MOTOR_TURN -> "start motor A turn 90"
        LineForm.RESET_MOTOR -> "reset motor A"
        LineForm.PEN -> "pen down"
        LineForm.WAIT -> "wait 1 second"
        LineForm.WAIT_UNTIL -> "wait until left bumper"
        LineForm.RESET_TIMER -> "reset timer"
        LineForm.BEEP -> "beep"
        LineForm.BUZZ -> "buzz"
        LineForm.PLAY -> "play 440 for 1 second"
        LineForm.SHOW -> "show 5"
        LineForm.SHOW_TEXT -> "show \"HELLO\""
        LineForm.CLEAR_SCREEN -> "clear screen"
        LineForm.REPEAT -> construct("repeat 4 times")
        LineForm.REPEAT_FOREVER -> construct("repeat forever")
        LineForm.REPEAT_WHILE -> construct("repeat while light > 40")
        LineForm.REPEAT_UNTIL -> construct("repeat until light < 40")
        LineForm.FOR -> construct("for i from 1 to 10")
        LineForm.FOR_WITH_STEP -> construct("for i from 0 to 10 step 2")
        LineForm.FOR_EACH -> construct("for each x in [1, 2, 3]")
        LineForm.BREAK -> "break"
        LineForm.CONTINUE -> "continue"
        LineForm.IF -> construct("if left bumper")
        LineForm.ELSE_IF -> construct("if left bumper", "else if right bumper")
        LineForm.ELSE -> construct("if left bumper", "else")
        LineForm.HALT -> "halt"
        LineForm.DECLARE_VARIABLE -> "var x = 5"
        LineForm.DECLARE_CONSTANT -> "const side = 20"
        LineForm.PROCEDURE -> construct("procedure trick()")
        LineForm.FUNCTION -> construct("function double(x)", "  return 2 * x")
        LineForm.RETURN -> "return"
        LineForm.RETURN_VALUE -> "return 5"
        LineForm.WHENEVER -> construct("whenever left bumper")
        LineForm.ROBOT -> construct("robot", "  light sensor on 2 facing down")
        LineForm.LIGHT_SENSOR -> "light sensor on 2 facing down"
        LineForm.BRICK -> "brick rcx"
        LineForm.SONAR -> "sonar on 4"
        LineForm.COLOUR_SENSOR -> "colour sensor on 3"
        LineForm.SOUND_SENSOR -> "sound sensor on 2"
        LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT, LineForm.CALL, LineForm.END -> null
    }

/** The same for a robot with [brick], null if it can do nothing like that. */
internal fun LineForm.templateOn(brick: BrickKind): String? = when {
    this.brick != null && this.brick != brick -> null
    brick == BrickKind.RCX -> template
    this == LineForm.LIGHT_SENSOR -> "light sensor on 3 facing down"
    this == LineForm.BRICK -> "brick nxt"
    this == LineForm.ROBOT -> construct("robot", "  brick nxt")
    else -> template
}

private fun construct(vararg lines: String): String = lines.joinToString("\n", postfix = "\nend")
