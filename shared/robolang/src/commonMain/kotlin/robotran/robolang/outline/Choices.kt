package robotran.robolang.outline

import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BrickButton
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.PaintColour
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.words.Keyword
import robotran.robolang.words.MOTORS
import robotran.robolang.words.PORTS
import robotran.robolang.words.SIDES
import robotran.robolang.words.ValueForm
import robotran.robolang.words.ValueUse
import robotran.robolang.words.texts

private val COLOURS = PaintColour.entries.map { it.keyword }.texts
private val TRUTHS = listOf(Keyword.TRUE, Keyword.FALSE).texts
private val LOGIC = listOf(Keyword.AND, Keyword.OR).texts
private val COMPARISONS = BinaryOperator.entries.filter { it.isComparison }.map { it.text }
private val ARITHMETIC = BinaryOperator.entries.filter { it.isArithmetic }.map { it.text }

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
        Sense.LeftBumper, Sense.RightBumper -> listOf(SIDES.texts)
        is Sense.Sensor -> PORTS.values.toList()
        is Sense.Button -> listOf(BrickButton.of(button.brick).map { it.keyword.text })
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
