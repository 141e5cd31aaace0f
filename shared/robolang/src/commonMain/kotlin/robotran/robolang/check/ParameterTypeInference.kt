package robotran.robolang.check

import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.bodies
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.parts
import robotran.robolang.words.ValueUse

/** Infers the types of parameters of routines that are never called, from their uses, unless they are numbers. */
internal class ParameterTypeInference(private val context: CheckContext) {
    /** Twice, since a routine's requirement may follow from another one further down. */
    fun settle() = repeat(2) { context.tree.routines.forEach { routine -> routine.body.forEach(::settle) } }

    private fun settle(statement: Statement) {
        when (statement) {
            is Command -> statement.values.forEach { (value, use) ->
                if (use == ValueUse.CONDITION) need(value, ValueType.TRUTH)
            }

            is Statement.RepeatWhile -> need(statement.condition, ValueType.TRUTH)
            is Statement.RepeatUntil -> need(statement.condition, ValueType.TRUTH)
            is Statement.If -> statement.branches.forEach { need(it.condition, ValueType.TRUTH) }
            is Statement.ForEach -> need(statement.list, ValueType.LIST_OF_WHOLE)
            is Statement.Assign -> assigned(statement)
            is Statement.Call -> handedOver(statement.name, statement.arguments)
            else -> Unit
        }
        statement.expressions.forEach(::settle)
        statement.bodies.forEach { it.forEach(::settle) }
    }

    private fun assigned(statement: Statement.Assign) {
        when (val target = statement.target) {
            is AssignTarget.Variable -> {
                context.draftsByName[target.name.range]?.let { need(statement.value, it.type.type) }
            }

            is AssignTarget.ListElement -> {
                context.draftsByName[target.list.range]?.let { raise(it, ValueType.LIST_OF_WHOLE) }
            }
        }
    }

    private fun settle(expression: Expression) {
        when (expression) {
            is Expression.Unary -> if (expression.operator == UnaryOperator.NOT) {
                need(expression.operand, ValueType.TRUTH)
            }

            is Expression.Binary -> settleOperands(expression)
            is Expression.ListElement -> need(expression.list, ValueType.LIST_OF_WHOLE)
            is Expression.Call -> handedOver(expression.name, expression.arguments)
            else -> Unit
        }
        expression.parts.forEach(::settle)
    }

    private fun handedOver(routine: Name, arguments: List<Expression>) {
        if (BuiltIn.of(routine.key) == BuiltIn.LENGTH) return arguments.forEach { need(it, ValueType.LIST_OF_WHOLE) }
        val parameters = context.routineOf(routine)?.parameters.orEmpty()
        parameters.zip(arguments) { parameter, argument ->
            context.draftsByName[parameter.range]?.let { need(argument, it.type.type) }
        }
    }

    private fun settleOperands(expression: Expression.Binary) {
        val joined = when (expression.operator) {
            BinaryOperator.AND, BinaryOperator.OR -> ValueType.TRUTH

            BinaryOperator.EQUAL, BinaryOperator.NOT_EQUAL -> expression.parts.map(context::typeOf).firstOrNull {
                it == ValueType.TRUTH || it == ValueType.COLOUR
            }

            else -> null
        }
        if (joined != null) needAll(expression, joined)
    }

    private fun needAll(expression: Expression, type: ValueType) = expression.parts.forEach { need(it, type) }

    private fun need(expression: Expression, type: ValueType) {
        when (expression) {
            is Expression.Brackets -> need(expression.inner, type)
            is Expression.Variable -> context.draftsByName[expression.name.range]?.let { raise(it, type) }
            else -> Unit
        }
    }

    private fun raise(draft: UnresolvedSymbol, type: ValueType) {
        val isOpen = draft.kind == SymbolKind.PARAMETER && draft.type.type == ValueType.NOTHING
        if (isOpen && !type.isNumber) draft.type.raise(type)
    }
}
