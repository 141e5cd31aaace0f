package robotran.robolang.run

import robotran.robolang.check.SymbolKind
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.UnaryOperator

/** Lowers expressions: their instructions push the value. */
internal class ExpressionLowering(private val emitter: Emitter, private val scope: LoweringScope) {
    private val builtIns = BuiltInLowering(emitter, scope, this)

    fun arithmeticOf(type: ValueType): Arithmetic = scope.arithmeticOf(type)

    /** Pushes the value as [wanted]: the expression's own type, or decimal for a whole number. */
    fun lower(expression: Expression, wanted: ValueType = scope.typeOf(expression)) {
        when (expression) {
            is Expression.Number -> lowerNumber(expression.value)
            is Expression.BooleanLiteral -> emitter.emit { it.pushTruth(expression.value) }
            is Expression.ColourLiteral -> emitter.emit { it.push(expression.colour.number) }
            is Expression.ListOf -> lowerList(expression)
            is Expression.Variable -> load(expression.name)
            is Expression.ListElement -> lowerElement(expression)
            is Expression.Unary -> lowerUnary(expression)
            is Expression.Binary -> lowerBinary(expression)
            is Expression.Call -> lowerCall(expression)
            is Expression.Sense -> lowerSense(expression.sense, emitter, scope.ports, scope.kind)
            is Expression.Brackets -> lower(expression.inner)
        }
        if (wanted == ValueType.DECIMAL && scope.typeOf(expression) == ValueType.WHOLE) {
            emitter.emit { it.pushDecimal(it.pop().toFloat()) }
        }
    }

    fun typeOf(expression: Expression): ValueType = scope.typeOf(expression)

    fun typeOf(name: Name): ValueType = scope.symbolOf(name).type

    fun load(name: Name) {
        val symbol = scope.symbolOf(name)
        val slot = symbol.index
        if (symbol.owner == null) {
            emitter.emit { it.push(it.machine.globals[slot]) }
        } else {
            emitter.emit { it.push(it.local(slot)) }
        }
    }

    /** [name] has a value from here to the end of its block. */
    fun declare(name: Name) = emitter.declare(scope.symbolOf(name))

    fun store(name: Name) {
        val symbol = scope.symbolOf(name)
        val slot = symbol.index
        if (symbol.owner == null) {
            emitter.emit { it.machine.globals[slot] = it.pop() }
        } else {
            emitter.emit { it.setLocal(slot, it.pop()) }
        }
    }

    /** Lowers a call of the routine [name]; drops an unused result. */
    fun call(name: Name, arguments: List<Expression>, isValueNeeded: Boolean) {
        val code = scope.codeOf(name)
        arguments.zip(scope.parametersOf(name)) { argument, type -> lower(argument, type) }
        emitter.emit { it.call(code) }
        if (!isValueNeeded && scope.symbolOf(name).kind == SymbolKind.FUNCTION) emitter.drop(1)
    }

    private fun lowerNumber(value: NumberValue) = when (value) {
        is NumberValue.Whole -> emitter.emit { it.push(value.value) }
        is NumberValue.Decimal -> emitter.emit { it.pushDecimal(value.decimal) }
    }

    private fun lowerList(expression: Expression.ListOf) {
        val type = scope.typeOf(expression).element
        val size = expression.elements.size
        expression.elements.forEach { lower(it, type) }
        emitter.emit {
            val list = it.machine.lists.create(size)
            val elements = it.machine.lists.elements(list)
            for (place in size - 1 downTo 0) elements[place] = it.pop()
            it.push(list)
        }
    }

    private fun lowerElement(expression: Expression.ListElement) {
        lower(expression.list)
        lower(expression.index)
        emitter.emit {
            val index = it.pop()
            it.push(it.machine.lists[it.pop(), index])
        }
    }

    private fun lowerUnary(expression: Expression.Unary) {
        val arithmetic = scope.arithmeticOf(scope.typeOf(expression))
        lower(expression.operand)
        when (expression.operator) {
            UnaryOperator.MINUS -> emitter.emit { it.push(arithmetic.negate(it.pop(), it.machine.messages)) }
            UnaryOperator.NOT -> emitter.emit { it.pushTruth(it.pop() == 0) }
        }
    }

    private fun lowerBinary(expression: Expression.Binary) {
        if (expression.operator == BinaryOperator.AND || expression.operator == BinaryOperator.OR) {
            return lowerLogic(expression)
        }
        val left = scope.typeOf(expression.left)
        val type = if (scope.typeOf(expression.right) == ValueType.DECIMAL) ValueType.DECIMAL else left
        lower(expression.left, type)
        lower(expression.right, type)
        emitter.emit(operation(expression.operator, scope.arithmeticOf(type)))
    }

    /** Evaluates the right operand only if the left one does not decide, as in Java. */
    private fun lowerLogic(expression: Expression.Binary) {
        val decided = Label()
        lower(expression.left)
        emitter.emit { it.push(it.peek()) }
        if (expression.operator == BinaryOperator.AND) emitter.jumpIfFalse(decided) else emitter.jumpIfTrue(decided)
        emitter.drop(1)
        lower(expression.right)
        emitter.put(decided)
    }

    private fun lowerCall(expression: Expression.Call) {
        val builtIn = BuiltIn.of(expression.name.key).takeIf {
            scope.symbolOf(expression.name).kind == SymbolKind.BUILT_IN
        }
        if (builtIn == null) {
            call(expression.name, expression.arguments, isValueNeeded = true)
        } else {
            builtIns.lower(builtIn, expression)
        }
    }
}
