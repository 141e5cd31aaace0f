package robotran.nqc.parse

import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Signs
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.Statement
import robotran.nqc.tree.UnaryOperator
import robotran.nqc.tree.VariableOperation

/** Reads assignments and other expressions that are statements. */
internal class AssignmentParser(private val reader: TokenReader, private val expressions: ExpressionParser) {
    private val sink = reader.sink

    /** Reads an assignment or an expression, without a semicolon. */
    fun statement(): Statement {
        val target = expressions.expression()
        val token = reader.token
        if (token.kind != TokenKind.SIGN || token.text !in Signs.ASSIGNMENTS) return evaluation(target)
        reader.advance()
        val value = expressions.expression()
        val range = target.range
        if (!isTarget(target)) {
            sink.report(NqcDiagnosticCode.NOT_ASSIGNABLE, range, sink.messages.notAssignable())
        }
        return if (token.text == "=") Statement.Assignment(target, value, range) else update(token.text, target, value)
    }

    private fun evaluation(value: Expression): Statement {
        if (!hasStep(value)) sink.report(NqcDiagnosticCode.NO_EFFECT, value.range, sink.messages.noEffect())
        return Statement.Evaluation(value, value.range)
    }

    private fun hasStep(expression: Expression): Boolean =
        expression is Expression.Step || expression.parts.any { hasStep(it) }

    private fun isTarget(target: Expression): Boolean = when (target) {
        is Expression.VariableUse -> target.variable.isAssignable
        is Expression.Element, is Expression.PointedAt, is Expression.Source, is Expression.IndexedSource -> true
        else -> false
    }

    private fun update(operator: String, target: Expression, value: Expression): Statement {
        val operation = OPERATIONS[operator]
        if (operation != null && target is Expression.VariableUse) {
            return Statement.Update(target, operation, value, target.range)
        }
        return Statement.Assignment(target, combined(operator, target, value), target.range)
    }

    /** The value of `target operator value` without the `=` of the operator. */
    private fun combined(operator: String, target: Expression, value: Expression): Expression {
        val range: SourceRange = value.range
        return when (operator) {
            "||=" -> Unary(UnaryOperator.ABSOLUTE, value, range)
            "+-=" -> Unary(UnaryOperator.SIGN, value, range)

            else -> {
                val binary = checkNotNull(BinaryOperator.of(operator.dropLast(1)))
                if (operator.length == SHIFT_LENGTH && !value.isPromisedConstant) {
                    sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, range, sink.messages.shiftNeedsConstant())
                }
                Binary(binary, target, value, range)
            }
        }
    }

    private companion object {
        /** The length of `<<=` and `>>=`. */
        const val SHIFT_LENGTH = 3

        val OPERATIONS = mapOf(
            "+=" to VariableOperation.ADD,
            "-=" to VariableOperation.SUBTRACT,
            "*=" to VariableOperation.MULTIPLY,
            "/=" to VariableOperation.DIVIDE,
            "&=" to VariableOperation.AND,
            "|=" to VariableOperation.OR,
            "||=" to VariableOperation.ABSOLUTE,
            "+-=" to VariableOperation.SIGN,
        )
    }
}
