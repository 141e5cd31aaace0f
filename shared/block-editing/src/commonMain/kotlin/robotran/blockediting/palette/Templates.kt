package robotran.blockediting.palette

import robotran.robolang.RobolangWords
import robotran.robolang.outline.LineForm
import robotran.robolang.outline.PhrasePart
import robotran.robolang.outline.ValueForm
import robotran.robolang.outline.outlineRobolang

/**
 * The lines that a palette block of this form has; null if there is none. Those that use names of the pupil's come from
 * the program, see [ownBlocks]. Numbers are those of the tutorial.
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
        LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT, LineForm.CALL, LineForm.END -> null
    }

private fun construct(vararg lines: String): String = lines.joinToString("\n", postfix = "\nend")

/** The values that palette blocks of this form have; those with names of the pupil's come from the program. */
internal val ValueForm.templates: List<String>
    get() = when (this) {
        ValueForm.NUMBER -> listOf("5")
        ValueForm.TRUTH -> listOf("true")
        ValueForm.LIST -> listOf("[1, 2, 3]")
        ValueForm.NEGATION -> listOf("-light")
        ValueForm.NOT -> listOf("not left bumper")
        ValueForm.LOGIC -> listOf("left bumper and right bumper")
        ValueForm.COMPARISON -> listOf("light < 40")
        ValueForm.ARITHMETIC -> listOf("5 + 5")
        ValueForm.BUILT_IN -> RobolangWords.functions.map { (name, parameters) -> callOf(name, parameters) }
        ValueForm.BUMPER -> listOf("left bumper")
        ValueForm.LIGHT -> listOf("light")
        ValueForm.SENSOR -> listOf("sensor 1")
        ValueForm.BUTTON -> listOf("button run")
        ValueForm.TIMER -> listOf("timer")
        ValueForm.BATTERY -> listOf("battery")
        ValueForm.BRACKETS -> listOf("(5)")
        ValueForm.NAME, ValueForm.ELEMENT, ValueForm.CALL -> emptyList()
    }

/** A call of the built-in function [name] with an example for each parameter. */
private fun callOf(name: String, parameters: Int): String {
    val anything = List(parameters) { "1" }.joinToString()
    val value = valuesIn("$name($anything)").first().value
    val examples = value.parts.filterIsInstance<PhrasePart.Value>().map { it.use.example }
    return examples.joinToString(prefix = "$name(", postfix = ")")
}

/** The values of the line that gives [value] to a variable; the first one is [value] itself. */
internal fun valuesIn(value: String): List<PhrasePart.Value> =
    outlineRobolang("var x = $value").lines.first().parts.filterIsInstance<PhrasePart.Value>()
