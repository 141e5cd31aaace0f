package robotran.robolang.run

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import kotlin.math.sqrt

/** Lowers calls of built-in functions. */
internal class BuiltInLowering(
    private val emitter: Emitter,
    private val scope: LoweringScope,
    private val expressions: ExpressionLowering,
) {
    fun lower(builtIn: BuiltIn, call: Expression.Call) {
        when (builtIn) {
            BuiltIn.LENGTH -> {
                expressions.lower(call.arguments.single())
                emitter.emit { it.push(it.machine.lists.elements(it.pop()).size) }
            }

            BuiltIn.ABS, BuiltIn.MIN, BuiltIn.MAX, BuiltIn.RANDOM -> lowerOfBothTypes(builtIn, call)
            BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL -> lowerRounding(builtIn, call)

            BuiltIn.SQRT, BuiltIn.SIN, BuiltIn.COS, BuiltIn.TAN, BuiltIn.ATAN2, BuiltIn.POW -> {
                lowerDecimal(builtIn, call)
            }
        }
    }

    /** Functions whose result is decimal if an operand is. */
    private fun lowerOfBothTypes(builtIn: BuiltIn, call: Expression.Call) {
        val type = scope.typeOf(call)
        val arithmetic = scope.arithmeticOf(type)
        call.arguments.forEach { expressions.lower(it, type) }
        emitter.emit(
            when (builtIn) {
                BuiltIn.ABS -> StackInstruction {
                    if (arithmetic.sign(it.peek()) < 0) {
                        it.push(arithmetic.negate(it.pop(), it.machine.messages))
                    }
                }

                BuiltIn.MIN -> choice { first, second -> if (arithmetic.isLess(second, first)) second else first }
                BuiltIn.MAX -> choice { first, second -> if (arithmetic.isLess(first, second)) second else first }
                else -> if (type == ValueType.DECIMAL) randomDecimal else randomWhole
            },
        )
    }

    private fun lowerRounding(builtIn: BuiltIn, call: Expression.Call) {
        val value = call.arguments.single()
        expressions.lower(value)
        if (scope.typeOf(value) == ValueType.WHOLE) return
        when (builtIn) {
            BuiltIn.FLOOR -> emitter.emit { it.push(floorToWhole(it.popDecimal())) }
            BuiltIn.CEIL -> emitter.emit { it.push(ceilToWhole(it.popDecimal())) }
            else -> emitter.emit { it.push(roundToWhole(it.popDecimal())) }
        }
        if (scope.hasShortNumbers) emitter.emit { it.push(short(it.pop().toLong(), it.machine.messages)) }
    }

    private fun lowerDecimal(builtIn: BuiltIn, call: Expression.Call) {
        call.arguments.forEach { expressions.lower(it, ValueType.DECIMAL) }
        when (builtIn) {
            BuiltIn.SQRT -> emitter.emit { it.pushDecimal(root(it.popDecimal(), it.machine)) }
            BuiltIn.SIN -> emitter.emit { it.pushDecimal(DecimalMath.sine(it.popDecimal())) }
            BuiltIn.COS -> emitter.emit { it.pushDecimal(DecimalMath.cosine(it.popDecimal())) }
            BuiltIn.TAN -> emitter.emit { it.pushDecimal(DecimalMath.tangent(it.popDecimal())) }

            BuiltIn.ATAN2 -> emitter.emit {
                val right = it.popDecimal()
                it.pushDecimal(DecimalMath.direction(it.popDecimal(), right))
            }

            else -> emitter.emit {
                val exponent = it.popDecimal()
                it.pushDecimal(power(it.popDecimal(), exponent, it.machine))
            }
        }
    }

    private fun root(value: Float, machine: InterpreterState): Float =
        if (value < 0f) fail(machine.messages.rootOfNegative(decimalText(value))) else sqrt(value)

    private fun power(base: Float, exponent: Float, machine: InterpreterState): Float {
        val isWhole = exponent.toInt().toFloat() == exponent
        if (base < 0f && !isWhole) fail(machine.messages.powerOfNegative(decimalText(base), decimalText(exponent)))
        return DecimalMath.power(base, exponent)
    }

    private val randomWhole = StackInstruction {
        val last = it.pop()
        it.push(it.machine.random.between(it.pop(), last))
    }

    private val randomDecimal = StackInstruction {
        val last = it.popDecimal()
        it.pushDecimal(it.machine.random.between(it.popDecimal(), last))
    }

    private inline fun choice(crossinline choose: (Int, Int) -> Int) = StackInstruction {
        val second = it.pop()
        it.push(choose(it.pop(), second))
    }
}
