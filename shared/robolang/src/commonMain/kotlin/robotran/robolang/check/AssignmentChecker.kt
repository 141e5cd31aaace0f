package robotran.robolang.check

import robotran.language.source.SourceFix
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.shortened

/** Finds assignments of values that do not fit the variable. */
internal class AssignmentChecker(private val context: CheckContext, private val expressions: ExpressionChecker) {
    private val messages = context.messages

    fun check(statement: Statement.Assign) {
        when (val target = statement.target) {
            is AssignTarget.Variable -> assignVariable(target.name, statement.value)
            is AssignTarget.ListElement -> assignElement(target, statement.value)
        }
    }

    private fun assignVariable(name: Name, value: Expression) {
        val draft = context.draftsByName[name.range] ?: return
        val text = shortened(name.text)
        val given = context.typeOf(value)
        val needed = draft.type.type
        when {
            draft.kind == SymbolKind.CONSTANT -> {
                context.report(DiagnosticCode.ASSIGNED_CONSTANT, name.range, messages.assignedConstant(text))
            }

            draft.kind == SymbolKind.LOOP_VARIABLE -> {
                context.report(DiagnosticCode.ASSIGNED_CONSTANT, name.range, messages.assignedLoopVariable(text))
            }

            needed == ValueType.WHOLE && given == ValueType.DECIMAL -> {
                context.report(
                    DiagnosticCode.TYPE_CHANGED,
                    value.range,
                    messages.decimalForWhole(text),
                    fixOfDeclaration(draft),
                )
            }

            !canHold(needed, given) -> {
                context.report(DiagnosticCode.TYPE_CHANGED, value.range, messages.typeChanged(text))
            }
        }
    }

    /** A variable with a whole number as its initial value can get a decimal one. */
    private fun fixOfDeclaration(draft: UnresolvedSymbol): SourceFix? {
        val value = context.declaredValues[draft.name.range] as? Expression.Number ?: return null
        return SourceFix(value.range, value.text + ".0")
    }

    private fun assignElement(target: AssignTarget.ListElement, value: Expression) {
        val list = context.draftsByName[target.list.range] ?: return
        val type = list.type.type
        if (!type.isList && type != ValueType.NOTHING) {
            context.report(
                DiagnosticCode.LIST_NEEDED,
                target.list.range,
                messages.listNeeded(shortened(target.list.text)),
            )
        }
        expressions.needElement(target.list, target.index)
        expressions.needType(type.element, value)
    }

    /** An unknown type was reported at its source. */
    private fun canHold(needed: ValueType, given: ValueType): Boolean =
        given == ValueType.NOTHING || needed == ValueType.NOTHING ||
            given == needed || (needed == ValueType.DECIMAL && given == ValueType.WHOLE)
}
