package robotran.nqc.tree

import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Source

/**
 * Where an instruction finds a value.
 *
 * @property type the number of the source, see [ValueSource].
 * @property data its argument; only its low bits get into an instruction.
 * @property usesTemporary whether the argument is a temporary variable with the number of another one.
 */
internal data class Place(val type: Int, val data: Int, val usesTemporary: Boolean = false) {
    constructor(source: ValueSource, data: Int) : this(source.code, data)

    val isVariable: Boolean get() = type == ValueSource.VARIABLE.code

    val isConstant: Boolean get() = type == ValueSource.CONSTANT.code
}

/** What `@number` means: the source in the upper 16 bits, the argument in the lower ones. */
internal fun placeOfSource(number: Int) = Place((number ushr SOURCE_BITS) and SOURCE_MASK, number and ARGUMENT_MASK)

/** The place of a value that needs no code; null if it needs some. */
internal fun sourceOf(expression: Expression): Place? {
    expression.constant?.let { return Place(ValueSource.CONSTANT, it) }
    return when (expression) {
        is Source -> expression.source.constant?.let { placeOfSource(it) }
        is Cell -> Place(ValueSource.VARIABLE, expression.place)
        is PointedAt -> Place(ValueSource.INDIRECT, expression.place)
        else -> null
    }
}

/** The number 0..2 of the sensor that [expression] is or names; null if it is none. */
internal fun sensorOf(expression: Expression): Int? = sourceOf(expression)
    ?.takeIf { it.isConstant || it.type == ValueSource.INPUT.code }
    ?.let { it.data and BYTE_MASK }

/** The number that `sete` knows the source [place] of an event by; null if events cannot come from there. */
internal fun eventSourceOf(place: Place): Int? = when (place.type) {
    ValueSource.INPUT.code -> place.data.takeIf { it in 0..2 }
    ValueSource.TIMER.code -> place.data.takeIf { it in 0..3 }?.plus(FIRST_TIMER)
    ValueSource.MESSAGE.code -> MESSAGE.takeIf { place.data == 0 }
    ValueSource.COUNTER.code -> place.data.takeIf { it in 0..2 }?.plus(FIRST_COUNTER)
    else -> null
}

private const val SOURCE_BITS = 16
private const val SOURCE_MASK = 0xFF
private const val ARGUMENT_MASK = 0xFFFF
private const val BYTE_MASK = 0xFF

/** Event sources: sensors are 0..2. Source: NQC. */
private const val FIRST_TIMER = 3
private const val MESSAGE = 7
private const val FIRST_COUNTER = 8
