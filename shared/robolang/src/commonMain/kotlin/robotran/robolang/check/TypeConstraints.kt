package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.robot.SensorPorts
import robotran.robolang.syntax.BuiltIn
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Sense
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.parts
import robotran.robolang.syntax.shortened
import robotran.robolang.words.BrickFeature

/** Adds the constraints between the types of expressions and their parts; [resolve] resolves a variable's name. */
internal class TypeConstraints(private val context: CheckContext, private val resolve: (Name) -> UnresolvedSymbol?) {
    /** The routine that a `return` belongs to. */
    var current: UnresolvedSymbol? = null

    /** Says what `sensor 1` and so on read, on a brick that has colour sensors. */
    private val portsWithColour by lazy(LazyThreadSafetyMode.NONE) {
        val hasColour = BrickFeature.COLOUR_SENSOR.isOn
        SensorPorts(context.tree, context.brick.takeIf(hasColour) ?: BrickKind.entries.first(hasColour))
    }

    /** The type of [expression], added once. */
    fun of(expression: Expression): TypeNode {
        context.nodes[expression.range]?.let { return it }
        expression.parts.forEach(::of)
        val node = TypeNode()
        context.nodes[expression.range] = node
        when (expression) {
            is Expression.Number -> node.raise(typeOf(expression))
            is Expression.BooleanLiteral -> node.raise(ValueType.TRUTH)
            is Expression.ColourLiteral -> node.raise(ValueType.COLOUR)
            is Expression.ListOf -> expression.elements.forEach { of(it).flowTo(node, TypeConstraint.LIST) }
            is Expression.Variable -> resolve(expression.name)?.type?.flowTo(node)
            is Expression.ListElement -> of(expression.list).flowTo(node, TypeConstraint.ELEMENT)
            is Expression.Unary -> unary(expression, node)
            is Expression.Binary -> binary(expression, node)
            is Expression.Call -> call(expression, node)
            is Expression.Sense -> node.raise(typeOf(expression.sense))
            is Expression.Brackets -> of(expression.inner).flowTo(node)
        }
        return node
    }

    private fun typeOf(number: Expression.Number): ValueType =
        if (number.value is NumberValue.Whole) ValueType.WHOLE else ValueType.DECIMAL

    private fun typeOf(sense: Sense): ValueType = when (sense) {
        Sense.LeftBumper, Sense.RightBumper, is Sense.Button -> ValueType.TRUTH
        is Sense.Sensor -> if (portsWithColour.senseAt(sense.port) ==
            Sense.Colour
        ) {
            ValueType.COLOUR
        } else {
            ValueType.WHOLE
        }
        Sense.Light, Sense.Distance, Sense.Loudness, is Sense.Turned -> ValueType.WHOLE
        Sense.Colour -> ValueType.COLOUR
        Sense.Timer, Sense.Battery -> ValueType.DECIMAL
    }

    private fun unary(expression: Expression.Unary, node: TypeNode) {
        when (expression.operator) {
            UnaryOperator.MINUS -> of(expression.operand).flowTo(node, TypeConstraint.NUMBER)
            UnaryOperator.NOT -> node.raise(ValueType.TRUTH)
        }
    }

    private fun binary(expression: Expression.Binary, node: TypeNode) {
        if (expression.operator.isArithmetic) {
            of(expression.left).flowTo(node, TypeConstraint.NUMBER)
            of(expression.right).flowTo(node, TypeConstraint.NUMBER)
        } else {
            node.raise(ValueType.TRUTH)
        }
    }

    private fun call(expression: Expression.Call, node: TypeNode) {
        val builtIn = BuiltIn.of(expression.name.key)
        when (builtIn) {
            null -> call(expression.name, expression.arguments)?.type?.flowTo(node)

            BuiltIn.ABS, BuiltIn.MIN, BuiltIn.MAX -> expression.arguments.forEach {
                of(it).flowTo(node, TypeConstraint.NUMBER)
            }

            BuiltIn.RANDOM, BuiltIn.ROUND, BuiltIn.FLOOR, BuiltIn.CEIL, BuiltIn.LENGTH -> node.raise(ValueType.WHOLE)

            BuiltIn.SQRT, BuiltIn.SIN, BuiltIn.COS, BuiltIn.TAN, BuiltIn.ATAN2, BuiltIn.POW -> node.raise(
                ValueType.DECIMAL,
            )
        }
    }

    /** A call of a routine: arguments flow to its parameters, which are declared later. */
    fun call(name: Name, arguments: List<Expression>): UnresolvedSymbol? {
        if (BuiltIn.of(name.key) != null) return null
        val routine = context.routines[name.key]
        if (routine == null) {
            if (!context.isExcused(name)) reportUnknown(name)
            return null
        }
        context.draftsByName[name.range] = routine
        context.calls += RoutineCall(name, arguments)
        return routine
    }

    private fun reportUnknown(name: Name) {
        val meant = context.nearestRoutine(name)
        val message = context.messages.unknownRoutine(shortened(name.text), meant)
        context.report(DiagnosticCode.UNKNOWN_ROUTINE, name.range, message, meant?.let { SourceFix(name.range, it) })
    }

    fun giveBack(statement: Statement.Return) {
        val routine = current ?: return
        if (routine.kind == SymbolKind.FUNCTION) statement.value?.let { of(it).flowTo(routine.type) }
    }
}

/** A call of a declared routine. */
internal class RoutineCall(val name: Name, val arguments: List<Expression>)
