package robotran.nqc.generate

import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Cell
import robotran.nqc.tree.Expression.Element
import robotran.nqc.tree.Expression.IndexedSource
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Query
import robotran.nqc.tree.Expression.Source
import robotran.nqc.tree.Place
import robotran.nqc.tree.QueryKind
import robotran.nqc.tree.VariableOperation
import robotran.nqc.tree.placeOfSource

/** Finds the places of variables, elements of arrays, and values of the brick. */
internal class PlaceEmitter(private val emitter: Emitter, private val values: ValueEmitter) {
    private val messages = emitter.sink.messages

    fun placeOf(expression: Expression): Place = when (expression) {
        is Cell -> Emitter.variable(expression.place)
        is PointedAt -> Place(ValueSource.INDIRECT, expression.place)
        is Element -> element(expression)
        is Source -> expression.source.constant?.let { placeOfSource(it) } ?: constantNeeded(expression.source)
        is IndexedSource -> indexedSource(expression)
        is Query -> unknown(expression)
        else -> constantNeeded(expression)
    }

    private fun element(expression: Element): Place {
        expression.index.constant?.let { return Emitter.variable(expression.place + it) }
        val temporary = emitter.temporary(expression.range)
        values.to(expression.index, temporary)
        if (expression.place != 0) {
            emitter.operation(VariableOperation.ADD, temporary, Emitter.constant(expression.place))
        }
        return Place(ValueSource.INDIRECT.code, temporary, usesTemporary = true)
    }

    /** A source with a constant argument, or another one whose argument is in a variable. */
    private fun indexedSource(expression: IndexedSource): Place {
        val sources = expression.sources.constant ?: return constantNeeded(expression.sources)
        val direct = Emitter.high(sources)
        val indirect = Emitter.low(sources)
        val constant = expression.index.constant
        if (direct != 0 && constant != null) return Place(direct, constant)
        (expression.index as? Cell)?.let { return Place(indirect, it.place) }
        val temporary = emitter.temporary(expression.range)
        values.to(expression.index, temporary)
        return Place(indirect, temporary, usesTemporary = true)
    }

    private fun unknown(expression: Query): Place {
        if (expression.kind == QueryKind.EVENT_SOURCE) {
            emitter.report(NqcDiagnosticCode.WRONG_EVENT_SOURCE, expression.operand.range, messages.wrongEventSource())
        } else {
            emitter.report(
                NqcDiagnosticCode.ARGUMENT_NOT_SENSOR,
                expression.operand.range,
                messages.argumentNotSensor(),
            )
        }
        return Emitter.constant(0)
    }

    private fun constantNeeded(expression: Expression): Place {
        emitter.report(NqcDiagnosticCode.CONSTANT_NEEDED, expression.range, messages.constantNeeded())
        return Emitter.constant(0)
    }

    /** The number of the variable that [target] is; null if it is none. */
    fun variableOf(target: Expression): Int? {
        if (target is Cell) return target.place
        emitter.report(NqcDiagnosticCode.NOT_ASSIGNABLE, target.range, messages.notSteppable())
        return null
    }
}
