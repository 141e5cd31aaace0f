package robotran.nqc.parse

import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.BinaryOperator
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.Binary
import robotran.nqc.tree.Expression.Choice
import robotran.nqc.tree.Expression.Source
import robotran.nqc.tree.Expression.Step
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.UnaryOperator

/** Reads expressions. */
internal class ExpressionParser(private val reader: TokenReader, names: NameResolver) {
    private val sink = reader.sink
    private val operands = OperandParser(reader, names, ::expression)

    fun expression(): Expression = reader.nested(NqcLimits.NESTED_STATEMENTS * 2) { choice() }

    /** Reads `(expression)`. */
    fun inBrackets(): Expression {
        reader.openingOfCondition()
        return expression().also { reader.closing(")") }
    }

    /** Reads an expression that must be constant where it is written and returns its value; 0 after a mistake. */
    fun constant(): Int = constantOf(expression())

    fun constantOf(expression: Expression): Int = expression.constant ?: 0.also {
        sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, expression.range, sink.messages.constantNeeded())
    }

    private fun choice(): Expression {
        val condition = binary(1)
        if (!reader.accept("?")) return condition
        val then = reader.nested(NqcLimits.NESTED_STATEMENTS * 2) { choice() }
        if (!reader.accept(":")) {
            reader.fail(NqcDiagnosticCode.MISSING_COLON, reader.gap, sink.messages.missingColon("?"))
        }
        val otherwise = binary(1)
        if (reader.isSign("?")) {
            reader.fail(NqcDiagnosticCode.SECOND_CHOICE, reader.token.range, sink.messages.secondChoice())
        }
        return limited(Choice(condition, then, otherwise, condition.range.to(otherwise.range)))
    }

    private fun binary(lowest: Int): Expression {
        var left = unary()
        while (true) {
            val token = reader.token
            if (token.kind != TokenKind.SIGN) return left
            val operator = BinaryOperator.of(token.text)?.takeIf { it.precedence >= lowest } ?: return left
            reader.advance()
            val right = binary(operator.precedence + 1)
            left = limited(checked(Binary(operator, left, right, left.range.to(right.range))))
        }
    }

    private fun checked(expression: Binary): Expression {
        val isShift =
            expression.operator == BinaryOperator.SHIFT_LEFT || expression.operator == BinaryOperator.SHIFT_RIGHT
        if (isShift && !expression.right.isPromisedConstant) {
            sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, expression.right.range, sink.messages.shiftNeedsConstant())
        }
        return expression
    }

    private fun unary(): Expression = reader.nested(NqcLimits.NESTED_STATEMENTS * 2) {
        val token = reader.token
        val operator = UNARY[token.text].takeIf { token.kind == TokenKind.SIGN }
        when {
            operator != null -> {
                reader.advance()
                val operand = unary()
                limited(Unary(operator, operand, token.range.to(operand.range)))
            }

            reader.isSign("@") -> source()

            reader.isSign("++") || reader.isSign("--") -> {
                reader.advance()
                step(unary(), token.text == "++", isPrefix = true)
            }

            reader.isSign("&") -> operands.addressOf()
            reader.isSign("*") -> operands.pointedAt()
            else -> postfix()
        }
    }

    private fun source(): Expression {
        val sign = reader.advance()
        val source = unary()
        if (!source.isPromisedConstant) {
            sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, source.range, sink.messages.constantNeeded())
        }
        return limited(Source(source, sign.range.to(source.range)))
    }

    private fun postfix(): Expression {
        var operand = operands.operand()
        while (reader.isSign("++") || reader.isSign("--")) {
            operand = step(operand, reader.advance().text == "++", isPrefix = false)
        }
        return operand
    }

    private fun step(target: Expression, isIncrement: Boolean, isPrefix: Boolean): Expression {
        val isVariable = target is Expression.VariableUse && target.variable.isAssignable
        if (!isVariable) sink.report(NqcDiagnosticCode.NOT_ASSIGNABLE, target.range, sink.messages.notSteppable())
        return if (isVariable) Step(target, isIncrement, isPrefix, target.range) else target
    }

    private fun limited(expression: Expression): Expression {
        val limit = NqcLimits.EXPRESSION_HEIGHT
        if (expression.height > limit) {
            reader.fail(NqcDiagnosticCode.NESTED_TOO_DEEPLY, expression.range, sink.messages.nestedTooDeeply(limit))
        }
        return expression
    }

    private companion object {
        val UNARY = mapOf(
            "-" to UnaryOperator.MINUS,
            "~" to UnaryOperator.COMPLEMENT,
            "!" to UnaryOperator.NOT,
        )
    }
}
