package robotran.robolang.outline

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Keyword
import robotran.robolang.syntax.PaintColour
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.UnaryOperator

private val SIDES = spellings(Keyword.LEFT, Keyword.RIGHT)
private val DIRECTIONS = spellings(Keyword.FORWARD, Keyword.BACKWARD)
private val PORTS = (1..BrickKind.RCX.inputPorts).map { it.toString() }
private val NXT_PORTS = (1..BrickKind.NXT.inputPorts).map { it.toString() }
private val MOTORS = MotorPort.entries.map { it.name }
private val MOTOR_COMMANDS = spellings(Keyword.FORWARD, Keyword.BACKWARD, Keyword.STOP, Keyword.FLOAT)
private val COLOURS = PaintColour.entries.map { it.keyword.text }
private val TRUTHS = spellings(Keyword.TRUE, Keyword.FALSE)
private val LOGIC = spellings(Keyword.AND, Keyword.OR)
private val COMPARISONS = BinaryOperator.entries.filter { it.isComparison }.map { it.text }
private val ARITHMETIC = BinaryOperator.entries.filter { it.isArithmetic }.map { it.text }

/** The words of a line of this form for which others may stand without changing it; each group is one choice. */
internal val LineForm.choices: List<List<String>>
    get() = when (this) {
        LineForm.MOVE, LineForm.MOVE_FOR_TIME, LineForm.START_MOVING -> listOf(DIRECTIONS)
        LineForm.TURN, LineForm.TURN_FOR_TIME, LineForm.START_TURNING, LineForm.POWER_OF_SIDE -> listOf(SIDES)
        LineForm.MOTOR -> listOf(MOTORS, MOTOR_COMMANDS)
        LineForm.POWER_OF_MOTOR, LineForm.MOTOR_TURN, LineForm.START_MOTOR_TURN, LineForm.RESET_MOTOR -> listOf(MOTORS)
        LineForm.PEN -> listOf(spellings(Keyword.DOWN, Keyword.UP))
        LineForm.WAIT -> listOf(spellings(Keyword.SECONDS, Keyword.MILLISECONDS))
        LineForm.LIGHT_SENSOR -> listOf(PORTS, NXT_PORTS, spellings(Keyword.DOWN, Keyword.FORWARD))
        LineForm.BRICK -> listOf(spellings(Keyword.RCX, Keyword.NXT))
        LineForm.SONAR, LineForm.COLOUR_SENSOR, LineForm.SOUND_SENSOR -> listOf(NXT_PORTS)
        LineForm.BEEP, LineForm.BUZZ, LineForm.REPEAT_WHILE, LineForm.REPEAT_UNTIL, LineForm.BREAK, LineForm.CONTINUE,
        LineForm.STOP, LineForm.POWER, LineForm.WAIT_UNTIL, LineForm.RESET_TIMER, LineForm.PLAY, LineForm.SHOW,
        LineForm.SHOW_TEXT, LineForm.CLEAR_SCREEN, LineForm.REPEAT, LineForm.REPEAT_FOREVER, LineForm.FOR,
        LineForm.FOR_WITH_STEP, LineForm.FOR_EACH, LineForm.IF, LineForm.ELSE_IF, LineForm.ELSE, LineForm.HALT,
        LineForm.DECLARE_VARIABLE, LineForm.DECLARE_CONSTANT, LineForm.ASSIGN, LineForm.ASSIGN_ELEMENT,
        LineForm.PROCEDURE, LineForm.FUNCTION, LineForm.CALL, LineForm.RETURN, LineForm.RETURN_VALUE,
        LineForm.WHENEVER, LineForm.ROBOT, LineForm.END,
        -> emptyList()
    }

/** The words of a value for which others may stand. */
internal val Expression.choices: List<List<String>>
    get() = when (this) {
        is Expression.BooleanLiteral -> listOf(TRUTHS)
        is Expression.ColourLiteral -> listOf(COLOURS)
        is Expression.Binary -> listOf(operator.alternatives)
        is Expression.Sense -> sense.choices
        is Expression.Number, is Expression.ListOf, is Expression.Variable, is Expression.ListElement,
        is Expression.Unary, is Expression.Call, is Expression.Brackets,
        -> emptyList()
    }

private val BinaryOperator.alternatives: List<String>
    get() = when {
        isArithmetic -> ARITHMETIC
        isComparison -> COMPARISONS
        else -> LOGIC
    }

private val Sense.choices: List<List<String>>
    get() = when (this) {
        Sense.LeftBumper, Sense.RightBumper -> listOf(SIDES)
        is Sense.Sensor -> listOf(PORTS, NXT_PORTS)
        is Sense.Button -> listOf(BrickButton.of(button.kind).map { it.keyword.text })
        is Sense.Turned -> listOf(MOTORS)
        Sense.Light, Sense.Timer, Sense.Battery, Sense.Distance, Sense.Loudness, Sense.Colour -> emptyList()
    }

internal val Sense.form: ValueForm
    get() = when (this) {
        Sense.LeftBumper, Sense.RightBumper -> ValueForm.BUMPER
        is Sense.Sensor -> ValueForm.SENSOR
        is Sense.Button -> ValueForm.BUTTON
        Sense.Light -> ValueForm.LIGHT
        Sense.Timer -> ValueForm.TIMER
        Sense.Battery -> ValueForm.BATTERY
        Sense.Distance -> ValueForm.DISTANCE
        Sense.Loudness -> ValueForm.LOUDNESS
        Sense.Colour -> ValueForm.COLOUR
        is Sense.Turned -> ValueForm.TURNED
    }

internal val UnaryOperator.form: ValueForm
    get() = when (this) {
        UnaryOperator.MINUS -> ValueForm.NEGATION
        UnaryOperator.NOT -> ValueForm.NOT
    }

internal val UnaryOperator.operandUse: ValueUse
    get() = when (this) {
        UnaryOperator.MINUS -> ValueUse.NUMBER
        UnaryOperator.NOT -> ValueUse.CONDITION
    }

internal val BinaryOperator.form: ValueForm
    get() = when {
        isArithmetic -> ValueForm.ARITHMETIC
        isComparison -> ValueForm.COMPARISON
        else -> ValueForm.LOGIC
    }

/** `==` and `!=` also compare conditions. */
internal val BinaryOperator.operandUse: ValueUse
    get() = when {
        this == BinaryOperator.EQUAL || this == BinaryOperator.NOT_EQUAL -> ValueUse.ANY
        isArithmetic || isComparison -> ValueUse.NUMBER
        else -> ValueUse.CONDITION
    }

private fun spellings(vararg keywords: Keyword): List<String> = keywords.map { it.text }
