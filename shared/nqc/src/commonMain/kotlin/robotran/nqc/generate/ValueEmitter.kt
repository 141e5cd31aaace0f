package robotran.nqc.generate

import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Choice
import robotran.nqc.tree.Expression.Constant
import robotran.nqc.tree.Expression.Step
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.OperatorKind
import robotran.nqc.tree.Place
import robotran.nqc.tree.UnaryOperator
import robotran.nqc.tree.VariableOperation

/** Generates the code that computes expressions, whose parameters and variables are already replaced. */
internal class ValueEmitter(private val emitter: Emitter) {
    private val conditions = ConditionEmitter(emitter, this)
    private val places = PlaceEmitter(emitter, this)
    private val combinations = CombinationEmitter(emitter, this)

    /** Computes [expression] wherever it is cheapest and returns the place. */
    fun any(expression: Expression): Place {
        emitter.work(1)
        val constant = expression.constant
        if (constant != null) {
            if (constant !in OPERANDS) {
                val message = emitter.sink.messages.numberOutOfRange(constant)
                emitter.report(NqcDiagnosticCode.NUMBER_OUT_OF_RANGE, expression.range, message)
            }
            return Emitter.constant(constant)
        }
        return when (expression) {
            is Binary -> anyBinary(expression)
            is Unary -> anyUnary(expression)
            is Choice -> anyChoice(expression)
            is Step -> anyStep(expression)
            else -> places.placeOf(expression)
        }
    }

    /** Computes [expression] into the variable [target]. */
    fun to(expression: Expression, target: Int) {
        emitter.work(1)
        val constant = expression.constant
        when {
            constant != null -> moveConstant(expression, constant, target)
            expression is Binary -> toBinary(expression, target)
            expression is Unary -> toUnary(expression, target)
            expression is Choice -> toChoice(expression, target)
            expression is Step -> toStep(expression, target)
            else -> throughAny(expression, target)
        }
    }

    private fun moveConstant(expression: Expression, constant: Int, target: Int) {
        if (constant !in OPERANDS) {
            val message = emitter.sink.messages.numberCut(constant, constant.toShort().toInt())
            emitter.report(NqcDiagnosticCode.NUMBER_CUT, expression.range, message)
        }
        emitter.move(target, Emitter.constant(constant))
    }

    /** Computes [expression] anywhere, then moves it to [target]. */
    fun throughAny(expression: Expression, target: Int) {
        val place = any(expression)
        emitter.move(target, place)
        emitter.release(place)
    }

    /** Computes [expression] to a place whose source is [allowed]; to a temporary variable if it is at none. */
    fun constrained(expression: Expression, allowsLocals: Boolean = true, allowed: (Int) -> Boolean): Place {
        val place = any(expression)
        if (allowed(place.type) && (allowsLocals || !isLocal(place))) return place
        if (!allowed(ValueSource.VARIABLE.code)) {
            emitter.report(NqcDiagnosticCode.WRONG_SOURCE, expression.range, emitter.sink.messages.wrongSource())
            return place
        }
        val temporary = emitter.temporary(expression.range, allowsLocals)
        emitter.move(temporary, place)
        emitter.release(place)
        return Emitter.variable(temporary)
    }

    private fun isLocal(place: Place) = place.isVariable && emitter.allocator.isLocal(place.data)

    /** Computes the second operand of an operation. The first firmware takes only variables and constants there. */
    fun operand(expression: Expression): Place = if (emitter.target == FirmwareTarget.RCX) {
        constrained(expression) { it in SIMPLE }
    } else {
        any(expression)
    }

    /** Does what [expression] changes, without its value. */
    fun sideEffects(expression: Expression) {
        if (expression is Step) step(expression) else expression.parts.forEach { sideEffects(it) }
    }

    fun branch(expression: Expression, label: Label, isWanted: Boolean) = conditions.branch(expression, label, isWanted)

    private fun anyBinary(expression: Binary): Place = when (expression.operator.kind) {
        OperatorKind.ARITHMETIC -> combinations.any(expression)
        OperatorKind.REWRITTEN -> combinations.anyRewritten(expression)
        OperatorKind.COMPARISON, OperatorKind.LOGICAL -> anyTruth(expression)
    }

    private fun toBinary(expression: Binary, target: Int) = when (expression.operator.kind) {
        OperatorKind.ARITHMETIC -> combinations.to(expression, target)
        OperatorKind.REWRITTEN -> combinations.toRewritten(expression, target)
        OperatorKind.COMPARISON, OperatorKind.LOGICAL -> toTruth(expression, target)
    }

    private fun anyUnary(expression: Unary): Place {
        asDifference(expression)?.let { return any(it) }
        if (expression.operator == UnaryOperator.NOT) return anyTruth(expression)
        val place = operand(expression.operand)
        val target = if (emitter.isTemporary(place)) place.data else emitter.temporary(expression.range)
        emitter.operation(operationOf(expression), target, place)
        if (emitter.releasesAll && place.usesTemporary) emitter.release(place)
        return Emitter.variable(target)
    }

    private fun toUnary(expression: Unary, target: Int) {
        val difference = asDifference(expression)
        if (difference != null) return to(difference, target)
        if (expression.operator == UnaryOperator.NOT) return toTruth(expression, target)
        val place = operand(expression.operand)
        emitter.operation(operationOf(expression), target, place)
        emitter.release(place)
    }

    private fun operationOf(expression: Unary) =
        if (expression.operator == UnaryOperator.ABSOLUTE) VariableOperation.ABSOLUTE else VariableOperation.SIGN

    /** `0 - x` for `-x`, and `-1 - x` for `~x`; null for other operators. */
    private fun asDifference(expression: Unary): Binary? {
        val minuend = when (expression.operator) {
            UnaryOperator.MINUS -> 0
            UnaryOperator.COMPLEMENT -> -1
            else -> return null
        }
        val range = expression.range
        return Binary(BinaryOperator.MINUS, Constant(minuend, range), expression.operand, range)
    }

    /** Computes a condition as 0 or 1. */
    private fun anyTruth(expression: Expression): Place {
        val target = emitter.temporary(expression.range)
        toTruth(expression, target)
        return Emitter.variable(target)
    }

    private fun toTruth(expression: Expression, target: Int) {
        val done = emitter.buffer.label()
        if (contains(expression, target)) {
            val isTrue = emitter.buffer.label()
            branch(expression, isTrue, isWanted = true)
            emitter.move(target, Emitter.constant(0))
            emitter.jump(done)
            emitter.buffer.place(isTrue)
            emitter.move(target, Emitter.constant(1))
        } else {
            emitter.move(target, Emitter.constant(0))
            branch(expression, done, isWanted = false)
            emitter.move(target, Emitter.constant(1))
        }
        emitter.buffer.place(done)
    }

    private fun anyChoice(expression: Choice): Place {
        expression.condition.constant?.let { return any(if (it != 0) expression.then else expression.otherwise) }
        val target = emitter.temporary(expression.range)
        toChoice(expression, target)
        return Emitter.variable(target)
    }

    private fun toChoice(expression: Choice, target: Int) {
        val constant = expression.condition.constant
        if (constant != null) return to(if (constant != 0) expression.then else expression.otherwise, target)
        val otherwise = emitter.buffer.label()
        val done = emitter.buffer.label()
        branch(expression.condition, otherwise, isWanted = false)
        to(expression.then, target)
        emitter.jump(done)
        emitter.buffer.place(otherwise)
        to(expression.otherwise, target)
        emitter.buffer.place(done)
    }

    private fun step(expression: Step) {
        val variable = places.variableOf(expression.target) ?: return
        val operation = if (expression.isIncrement) VariableOperation.ADD else VariableOperation.SUBTRACT
        emitter.operation(operation, variable, Emitter.constant(1))
    }

    private fun anyStep(expression: Step): Place {
        val variable = Emitter.variable(places.variableOf(expression.target) ?: 0)
        if (expression.isPrefix) {
            step(expression)
            return variable
        }
        val temporary = emitter.temporary(expression.range)
        emitter.move(temporary, variable)
        step(expression)
        return Emitter.variable(temporary)
    }

    private fun toStep(expression: Step, target: Int) {
        val variable = places.variableOf(expression.target) ?: return
        if (expression.isPrefix) {
            step(expression)
            emitter.move(target, Emitter.variable(variable))
        } else if (target != variable) {
            emitter.move(target, Emitter.variable(variable))
            step(expression)
        }
    }

    private companion object {
        /** The constants that an instruction can hold, with or without a sign. */
        val OPERANDS = -32768..65535

        val SIMPLE = setOf(ValueSource.VARIABLE.code, ValueSource.CONSTANT.code)
    }
}
