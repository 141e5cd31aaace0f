package robotran.robolang.python.microbit

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Sense

/** The ranges of what functions give back, and of what a robot measures. */
internal class RangesOfCalls(private val ranges: Ranges, private val lengths: ListLengths) {
    /** Null as long as nothing is known. */
    fun of(call: Expression.Call, program: CheckedProgram): Span? {
        val symbol = program.symbolOf(call.name)
        if (symbol.declaredAt != null) return ranges.ofSymbol(symbol)
        if (program.typeOf(call) != ValueType.WHOLE) return Span.WORD
        return when (BuiltIn.of(call.name.key)) {
            BuiltIn.ABS -> ranges.known(call.arguments[0])?.let { Span(0.0, it.largest) }
            BuiltIn.MIN -> both(call) { one, other -> Span(minOf(one.min, other.min), minOf(one.max, other.max)) }
            BuiltIn.MAX -> both(call) { one, other -> Span(maxOf(one.min, other.min), maxOf(one.max, other.max)) }
            BuiltIn.RANDOM -> both(call, Span::with)
            BuiltIn.LENGTH -> lengths.of(call.arguments[0]).let { Span(it?.first.orZero(), it?.last.orMost()) }
            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> whole(call.arguments[0], program)
            else -> Span.WORD
        }
    }

    private fun Int?.orZero(): Double = this?.toDouble() ?: 0.0

    private fun Int?.orMost(): Double = this?.toDouble() ?: MOST_ELEMENTS

    private fun whole(value: Expression, program: CheckedProgram): Span? {
        val isWhole = (value !is Expression.Number) && program.typeOf(value) == ValueType.WHOLE
        return if (isWhole) ranges.known(value) else Span.WORD
    }

    private fun both(call: Expression.Call, join: (Span, Span) -> Span): Span? {
        val first = ranges.known(call.arguments[0]) ?: return null
        return ranges.known(call.arguments[1])?.let { join(first, it) }
    }

    fun of(sense: Sense): Span = when (sense) {
        Sense.Light, Sense.Loudness -> Span(0.0, HUNDRED)
        Sense.Distance, is Sense.Sensor -> Span(0.0, BYTE)
        else -> Span.WORD
    }

    private companion object {
        const val HUNDRED = 100.0
        const val BYTE = 255.0

        /** More than a board has room for. */
        const val MOST_ELEMENTS = 16_384.0
    }
}
