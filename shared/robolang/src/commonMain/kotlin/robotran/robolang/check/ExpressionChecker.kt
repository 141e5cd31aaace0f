package robotran.robolang.check

import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.RobolangLimits
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.parts
import robotran.robolang.syntax.shortened
import robotran.robolang.words.BrickDialect

/** Checks the types of expressions. */
internal class ExpressionChecker(private val context: CheckContext) {
    private val messages = context.messages

    /** Checks [expression] bottom-up, so that the innermost error is reported first. */
    fun check(expression: Expression) {
        expression.parts.forEach(::check)
        when (expression) {
            is Expression.ListOf -> list(expression)
            is Expression.ListElement -> element(expression)
            is Expression.Unary -> unary(expression)
            is Expression.Binary -> binary(expression)
            is Expression.Call -> call(expression)
            is Expression.Number,
            is Expression.BooleanLiteral,
            is Expression.ColourLiteral,
            is Expression.Variable,
            is Expression.Sense,
            is Expression.Brackets,
            -> Unit
        }
    }

    fun needNumber(expression: Expression) {
        val type = context.typeOf(expression)
        if (!type.isNumber && isKnown(expression)) {
            context.report(
                DiagnosticCode.NUMBER_NEEDED,
                expression.range,
                messages.numberNeeded(context.quotable(expression)),
            )
        }
    }

    fun needWhole(expression: Expression) {
        needNumber(expression)
        if (context.typeOf(expression) == ValueType.DECIMAL) {
            val fix = SourceFix(expression.range, "round(${context.textOf(expression.range)})")
            val message = messages.wholeNumberNeeded(context.quotable(expression))
            context.report(DiagnosticCode.WHOLE_NUMBER_NEEDED, expression.range, message, fix)
        }
    }

    fun needCondition(expression: Expression) {
        if (context.typeOf(expression) != ValueType.TRUTH && isKnown(expression)) {
            context.report(
                DiagnosticCode.CONDITION_NEEDED,
                expression.range,
                messages.conditionNeeded(context.quotable(expression)),
            )
        }
    }

    private fun needColour(expression: Expression) {
        if (context.typeOf(expression) != ValueType.COLOUR && isKnown(expression)) {
            val message = messages.colourNeeded(context.quotable(expression))
            context.report(DiagnosticCode.COLOUR_NEEDED, expression.range, message)
        }
    }

    /** Checks what can be shown: a number or a colour. */
    fun needShown(expression: Expression) {
        if (context.typeOf(expression) != ValueType.COLOUR) needNumber(expression)
    }

    fun needList(expression: Expression) {
        if (!context.typeOf(expression).isList && isKnown(expression)) {
            context.report(
                DiagnosticCode.LIST_NEEDED,
                expression.range,
                messages.listNeeded(context.quotable(expression)),
            )
        }
    }

    fun needElement(list: Name, index: Expression) {
        needWhole(index)
        val place = (context.constantOf(index) as? NumberValue.Whole)?.value ?: return
        if (place < 0) context.report(DiagnosticCode.INDEX_OUT_OF_RANGE, index.range, messages.indexNegative())
        val length = context.draftsByName[list.range]?.takeUnless { it.isAssigned }?.listLength ?: return
        reportBeyond(index, place, length)
    }

    /** Checks the arguments of a call of the known routine [name]. */
    fun arguments(name: Name, arguments: List<Expression>) {
        val builtIn = BuiltIn.of(name.key)
        if (builtIn != null) return builtIn(builtIn, name, arguments)
        val routine = context.routineOf(name) ?: return
        if (routine.range.line in context.errorLines) return
        if (!isCount(name, routine.parameters.size, arguments.size)) return
        routine.parameters.zip(arguments).forEach { (parameter, argument) ->
            context.draftsByName[parameter.range]?.let { needType(it.type.type, argument) }
        }
    }

    /** Checks that [expression] has [type]; a whole number is accepted as a decimal one. */
    fun needType(type: ValueType, expression: Expression) {
        when (type) {
            ValueType.WHOLE -> needWhole(expression)
            ValueType.DECIMAL -> needNumber(expression)
            ValueType.TRUTH -> needCondition(expression)
            ValueType.COLOUR -> needColour(expression)
            ValueType.LIST_OF_WHOLE, ValueType.LIST_OF_DECIMAL -> needListOf(type, expression)
            ValueType.NOTHING -> Unit
        }
    }

    private fun needListOf(type: ValueType, expression: Expression) {
        needList(expression)
        val given = context.typeOf(expression)
        if (given.isList && given != type) {
            context.report(
                DiagnosticCode.TYPE_CHANGED,
                expression.range,
                messages.typeChanged(context.quotable(expression)),
            )
        }
    }

    /** False if an error further inside left the type unknown; that one was reported. */
    private fun isKnown(expression: Expression): Boolean = context.typeOf(expression) != ValueType.NOTHING

    private fun list(expression: Expression.ListOf) {
        if (expression.elements.isEmpty()) {
            context.report(
                DiagnosticCode.EMPTY_LIST,
                expression.range,
                messages.emptyList(),
            )
        }
        if (expression.elements.size > RobolangLimits.LIST_ELEMENTS) {
            context.report(
                DiagnosticCode.LIST_TOO_LONG,
                expression.range,
                messages.listTooLong(RobolangLimits.LIST_ELEMENTS),
            )
        }
        for (element in expression.elements) {
            if (!context.typeOf(element).isNumber && isKnown(element)) {
                context.report(DiagnosticCode.MIXED_LIST, element.range, messages.mixedList(context.quotable(element)))
            }
        }
    }

    private fun element(expression: Expression.ListElement) {
        needList(expression.list)
        val list = expression.list
        if (list is Expression.Variable) return needElement(list.name, expression.index)
        needWhole(expression.index)
        val place = (context.constantOf(expression.index) as? NumberValue.Whole)?.value ?: return
        if (list is Expression.ListOf) reportBeyond(expression.index, place, list.elements.size)
    }

    private fun reportBeyond(index: Expression, place: Int, length: Int) {
        if (place !in
            0 until length
        ) {
            context.report(DiagnosticCode.INDEX_OUT_OF_RANGE, index.range, messages.indexOutOfRange(length - 1))
        }
    }

    private fun unary(expression: Expression.Unary) {
        when (expression.operator) {
            UnaryOperator.MINUS -> needNumber(expression.operand)
            UnaryOperator.NOT -> needCondition(expression.operand)
        }
    }

    private fun binary(expression: Expression.Binary) {
        val operands = listOf(expression.left, expression.right)
        when (expression.operator) {
            BinaryOperator.OR, BinaryOperator.AND -> operands.forEach(::needCondition)
            BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL -> equality(expression)
            else -> if (!isChained(expression)) operands.forEach(::needNumber)
        }
        if (expression.operator == BinaryOperator.DIVIDE || expression.operator == BinaryOperator.MOD) {
            division(expression)
        }
    }

    /** Reports `3 < x < 5`, which is not valid in Robolang or Java. */
    private fun isChained(expression: Expression.Binary): Boolean {
        val first = expression.left as? Expression.Binary ?: return false
        if (!first.operator.isComparison || !expression.operator.isComparison) return false
        val right =
            "${context.textOf(first.range)} and ${context.textOf(first.right.range)} ${expression.operator.text} " +
                context.textOf(expression.right.range)
        val message = messages.chainedComparison(shortened(right))
        context.report(DiagnosticCode.NUMBER_NEEDED, expression.range, message, SourceFix(expression.range, right))
        return true
    }

    private fun equality(expression: Expression.Binary) {
        val left = context.typeOf(expression.left)
        val right = context.typeOf(expression.right)
        if (left == ValueType.NOTHING || right == ValueType.NOTHING) return
        val comparable = (left.isNumber && right.isNumber) || (left == right && left in EQUAL_ONLY)
        if (!comparable) context.report(DiagnosticCode.NOT_COMPARABLE, expression.range, messages.notComparable())
    }

    private fun division(expression: Expression.Binary) {
        val divisor = context.constantOf(expression.right) ?: return
        if (divisor !is NumberValue.Whole || context.typeOf(expression) != ValueType.WHOLE) return
        if (divisor.value == 0) {
            return context.report(
                DiagnosticCode.DIVISION_BY_ZERO,
                expression.right.range,
                messages.divisionByZero(),
            )
        }
        val isTooLarge = divisor.value !in Short.MIN_VALUE..Short.MAX_VALUE
        if (isTooLarge && BrickDialect.of(context.brick).dividesByShort) warnOfDivisor(expression.right, divisor.value)
        val dividend = (context.constantOf(expression.left) as? NumberValue.Whole)?.value ?: return
        if (expression.operator == BinaryOperator.MOD || dividend % divisor.value == 0) return
        val message = messages.fractionLost(context.quotable(expression), dividend / divisor.value)
        val left = expression.left
        val fix = if (left is Expression.Number) SourceFix(left.range, left.text + ".0") else null
        context.warn(DiagnosticCode.FRACTION_LOST, expression.range, message, fix)
    }

    /** The brick uses only the lower 16 bits of a divisor. */
    private fun warnOfDivisor(expression: Expression, divisor: Int) {
        val kept = divisor.toShort().toInt()
        val message = if (kept == 0) messages.divisorTakenForZero(divisor) else messages.divisorTooLarge(divisor, kept)
        context.warn(DiagnosticCode.DIVISOR_TOO_LARGE, expression.range, message)
    }

    private fun call(expression: Expression.Call) {
        val name = expression.name
        if (context.draftsByName[name.range]?.kind == SymbolKind.PROCEDURE) {
            context.report(DiagnosticCode.VALUE_NEEDED, name.range, messages.valueNeeded(shortened(name.text)))
        }
        arguments(name, expression.arguments)
    }

    private fun builtIn(function: BuiltIn, name: Name, arguments: List<Expression>) {
        if (!isCount(name, function.parameters, arguments.size)) return
        when (function) {
            BuiltIn.RANDOM -> arguments.forEach(::needWhole)
            BuiltIn.LENGTH -> arguments.forEach(::needList)
            else -> arguments.forEach(::needNumber)
        }
    }

    private fun isCount(name: Name, needed: Int, given: Int): Boolean {
        if (needed == given) return true
        val message = messages.wrongArgumentCount(shortened(name.text), needed, given)
        context.report(DiagnosticCode.WRONG_ARGUMENT_COUNT, name.range, message)
        return false
    }

    private companion object {
        /** The types of values that are equal or not, but not smaller or larger. */
        val EQUAL_ONLY = setOf(ValueType.TRUTH, ValueType.COLOUR)
    }
}
