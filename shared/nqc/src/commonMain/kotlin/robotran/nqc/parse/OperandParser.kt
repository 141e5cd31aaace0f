package robotran.nqc.parse

import robotran.language.source.SourceRange
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Keyword
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind
import robotran.nqc.tree.Expression
import robotran.nqc.tree.Expression.AddressOf
import robotran.nqc.tree.Expression.Constant
import robotran.nqc.tree.Expression.Element
import robotran.nqc.tree.Expression.IndexedSource
import robotran.nqc.tree.Expression.PointedAt
import robotran.nqc.tree.Expression.Query
import robotran.nqc.tree.Expression.TaskNumber
import robotran.nqc.tree.Expression.Unary
import robotran.nqc.tree.Expression.VariableUse
import robotran.nqc.tree.QueryKind
import robotran.nqc.tree.UnaryOperator

/** Reads what operators connect: numbers, variables, brackets. */
internal class OperandParser(
    private val reader: TokenReader,
    private val names: NameResolver,
    private val expression: () -> Expression,
) {
    private val sink = reader.sink

    fun operand(): Expression {
        val token = reader.token
        return when {
            token.kind == TokenKind.NUMBER -> Constant(reader.advance().value, token.range)
            token.kind == TokenKind.NAME -> named()
            token.kind == TokenKind.KEYWORD -> ofKeyword(token)
            reader.isSign("@@") -> indexedSource()
            reader.accept("(") -> expression().also { reader.closing(")") }
            else -> reader.missingValue()
        }
    }

    private fun ofKeyword(token: Token): Expression = when (token.keyword) {
        Keyword.TRUE -> Constant(1, reader.advance().range)
        Keyword.FALSE -> Constant(0, reader.advance().range)
        Keyword.TASK_NUMBER -> TaskNumber(reader.advance().range)
        Keyword.ABS -> function { operand, range -> Unary(UnaryOperator.ABSOLUTE, operand, range) }
        Keyword.SIGN -> function { operand, range -> Unary(UnaryOperator.SIGN, operand, range) }
        Keyword.SENSOR -> function { operand, range -> Query(QueryKind.SENSOR, operand, range) }
        Keyword.TYPE -> function { operand, range -> Query(QueryKind.TYPE, operand, range) }
        Keyword.EVENT_SOURCE -> function { operand, range -> Query(QueryKind.EVENT_SOURCE, operand, range) }
        else -> reader.missingValue()
    }

    private fun function(make: (Expression, SourceRange) -> Expression): Expression {
        val word = reader.advance()
        reader.opening("(")
        val operand = expression()
        reader.closing(")")
        return make(operand, word.range.to(reader.previous.range))
    }

    private fun named(): Expression {
        val name = reader.advance()
        if (reader.isSign("(")) names.failAtCallAsValue(name)
        if (!reader.accept("[")) {
            val variable = names.variable(name)
            if (variable.isArray) report(NqcDiagnosticCode.IS_ARRAY, name, sink.messages.isArray(name.text))
            return VariableUse(variable, name.range)
        }
        val index = expression()
        reader.closing("]")
        val variable = names.variable(name)
        if (!variable.isArray && !names.isUnknown(variable)) {
            report(NqcDiagnosticCode.IS_NOT_ARRAY, name, sink.messages.isNotArray(name.text))
        }
        val place = index.constant
        if (variable.isArray && place != null && place !in 0 until variable.size) {
            val message = sink.messages.indexOutside(name.text, variable.size - 1)
            sink.report(NqcDiagnosticCode.INDEX_OUTSIDE, index.range, message)
        }
        return Element(variable, index, name.range.to(reader.previous.range))
    }

    /** Reads `&name` or `&name[index]`. */
    fun addressOf(): Expression {
        val sign = reader.advance()
        val name = reader.name()
        val variable = names.variable(name)
        var offset = 0
        if (reader.accept("[")) {
            val index = expression()
            reader.closing("]")
            if (variable.isArray) {
                offset = index.constant ?: 0.also {
                    sink.report(
                        NqcDiagnosticCode.ADDRESS_NOT_CONSTANT,
                        index.range,
                        sink.messages.addressNotConstant(),
                    )
                }
            } else {
                report(NqcDiagnosticCode.IS_NOT_ARRAY, name, sink.messages.isNotArray(name.text))
            }
        }
        return AddressOf(variable, offset, sign.range.to(reader.previous.range))
    }

    /** Reads `*name`. */
    fun pointedAt(): Expression {
        val sign = reader.advance()
        val name = reader.name()
        val variable = names.variable(name)
        if (!variable.isPointer) names.requirePointers(name.range)
        when {
            names.isUnknown(variable) -> Unit
            variable.isArray -> report(NqcDiagnosticCode.IS_ARRAY, name, sink.messages.isArray(name.text))
            !variable.isPointer -> report(NqcDiagnosticCode.IS_NOT_POINTER, name, sink.messages.isNotPointer(name.text))
        }
        return PointedAt(variable, sign.range.to(name.range))
    }

    private fun indexedSource(): Expression {
        val sign = reader.advance()
        reader.opening("(")
        val sources = expression()
        reader.closing(")")
        reader.opening("[")
        val index = expression()
        reader.closing("]")
        if (!sources.isPromisedConstant) {
            sink.report(NqcDiagnosticCode.CONSTANT_NEEDED, sources.range, sink.messages.constantNeeded())
        }
        return IndexedSource(sources, index, sign.range.to(reader.previous.range))
    }

    private fun report(code: NqcDiagnosticCode, name: Token, message: String) = sink.report(code, name.range, message)
}
