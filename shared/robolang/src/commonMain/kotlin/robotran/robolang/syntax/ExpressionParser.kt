package robotran.robolang.syntax

import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.words.Keyword
import robotran.robolang.words.SIDES

/**
 * Parses the expressions of one line by recursive descent over operator precedence. Each function returns null once it
 * has reported an error. The nesting depth is limited, since all phases walk expressions recursively.
 */
internal class ExpressionParser(private val reader: LineReader, private val diagnostics: DiagnosticSink) {
    private var depth = 0
    private var listDepth = 0

    /** The nesting depth of the last expression. */
    private var height = 0

    /** Parses a required expression; [example] completes the line so far. */
    fun expression(expected: Expected, example: String): Expression? {
        if (lacksCount() || !canBegin(reader.next)) return diagnostics.reportMissingValue(reader, expected, example)
        return binary(BinaryOperator.OR.strength)
    }

    private fun lacksCount(): Boolean =
        reader.first.keyword == Keyword.REPEAT && reader.next?.keyword == Keyword.TIMES &&
            reader.peek(1).let { it == null || it.kind == TokenKind.NUMBER }

    /** The arguments of a call, after its opening bracket. */
    fun arguments(): List<Expression>? = elements(TokenKind.CLOSE_BRACKET)

    private fun binary(weakest: Int): Expression? {
        var left = operand(weakest) ?: return null
        while (true) {
            val operator = operatorOf(reader.next)?.takeIf { it.strength >= weakest } ?: return left
            val heightOfLeft = height
            if (reader.next?.kind == TokenKind.ASSIGN) diagnostics.reportAssignmentInsteadOfComparison(reader)
            reader.advance()
            if (!canBegin(reader.next)) return diagnostics.reportMissingOperand(reader, operator.text)
            val right = binary(operator.strength + 1) ?: return null
            height = maxOf(heightOfLeft, height) + 1
            if (height > RobolangLimits.NESTED_EXPRESSIONS) return diagnostics.reportDeepExpression(reader)
            left = Expression.Binary(reader.rangeFrom(left.range), operator, left, right)
        }
    }

    private fun operand(weakest: Int): Expression? {
        if (depth >= RobolangLimits.NESTED_EXPRESSIONS) return diagnostics.reportDeepExpression(reader)
        depth++
        val operand = when {
            reader.next?.keyword == Keyword.NOT -> unary(UnaryOperator.NOT) {
                binary(maxOf(weakest, STRENGTH_OF_NOT + 1))
            }

            reader.next?.kind != TokenKind.MINUS -> postfix()
            reader.peek(1)?.kind == TokenKind.NUMBER -> leaf(readNumberExpression(reader, diagnostics, listDepth > 0))
            else -> unary(UnaryOperator.MINUS) { operand(weakest) }
        }
        depth--
        return operand
    }

    private fun unary(operator: UnaryOperator, readOperand: () -> Expression?): Expression? {
        val sign = checkNotNull(reader.next)
        reader.advance()
        if (!canBegin(reader.next)) return diagnostics.reportMissingOperand(reader, operator.text)
        val operand = readOperand() ?: return null
        height++
        return Expression.Unary(reader.rangeFrom(sign.range), operator, operand)
    }

    private fun postfix(): Expression? {
        var value = primary() ?: return null
        while (reader.next?.kind == TokenKind.OPEN_LIST && value !is Expression.Number) {
            val opening = checkNotNull(reader.next)
            val heightOfList = height
            reader.advance()
            val index = inner() ?: return null
            if (reader.take(TokenKind.CLOSE_LIST) == null) return diagnostics.reportMissingBracket(reader, opening, "]")
            height = maxOf(heightOfList, height) + 1
            if (height > RobolangLimits.NESTED_EXPRESSIONS) return diagnostics.reportDeepExpression(reader)
            value = Expression.ListElement(reader.rangeFrom(value.range), value, index)
        }
        return value
    }

    private fun primary(): Expression? {
        val token = checkNotNull(reader.next)
        return when (token.kind) {
            TokenKind.NUMBER -> leaf(readNumberExpression(reader, diagnostics, listDepth > 0))
            TokenKind.OPEN_BRACKET -> brackets(token)
            TokenKind.OPEN_LIST -> list(token)
            else -> if (token.canBeName) named(token) else leaf(readWordExpression(reader, diagnostics))
        }
    }

    private fun leaf(expression: Expression?): Expression? {
        height = 1
        return expression
    }

    private fun named(token: Token): Expression? {
        if (token.keyword == Keyword.BUMPER && reader.peek(1)?.keyword in SIDES) {
            return diagnostics.reportTurnedBumper(reader)
        }
        val name = checkNotNull(reader.takeName())
        if (reader.take(TokenKind.OPEN_BRACKET) == null) return leaf(Expression.Variable(token.range, name))
        val arguments = elements(TokenKind.CLOSE_BRACKET) ?: return null
        height++
        return Expression.Call(reader.rangeFrom(token.range), name, arguments)
    }

    private fun brackets(opening: Token): Expression? {
        reader.advance()
        val inner = inner() ?: return null
        if (reader.take(TokenKind.CLOSE_BRACKET) == null) return diagnostics.reportMissingBracket(reader, opening, ")")
        height++
        return Expression.Brackets(reader.rangeFrom(opening.range), inner)
    }

    private fun list(opening: Token): Expression? {
        reader.advance()
        val elements = elements(TokenKind.CLOSE_LIST) ?: return null
        height++
        return Expression.ListOf(reader.rangeFrom(opening.range), elements)
    }

    /** Expressions separated by commas, up to the [closing] bracket. */
    private fun elements(closing: TokenKind): List<Expression>? {
        val opening = checkNotNull(reader.peek(-1))
        val elements = mutableListOf<Expression>()
        var highest = 0
        if (reader.take(closing) != null) {
            height = 0
            return elements
        }
        listDepth++
        do {
            elements += inner() ?: return null
            highest = maxOf(highest, height)
        } while (reader.take(TokenKind.COMMA) != null)
        listDepth--
        height = highest
        if (reader.take(closing) != null) return elements
        return if (canBegin(reader.next)) {
            diagnostics.reportMissingComma(reader)
        } else {
            diagnostics.reportMissingBracket(reader, opening, checkNotNull(closing.text))
        }
    }

    private fun inner(): Expression? {
        val before = checkNotNull(reader.peek(-1))
        if (!canBegin(reader.next)) return diagnostics.reportMissingOperand(reader, before.text)
        return binary(BinaryOperator.OR.strength)
    }
}

internal enum class Expected { NUMBER, CONDITION, VALUE }

private val BEGINNING_KINDS = setOf(TokenKind.NUMBER, TokenKind.MINUS, TokenKind.OPEN_BRACKET, TokenKind.OPEN_LIST)

/** Whether an expression can begin with [token]. */
internal fun canBegin(token: Token?): Boolean =
    token != null && (token.kind in BEGINNING_KINDS || token.keyword?.beginsValue == true || token.canBeName)

/** A single `=` counts as a comparison here, since nothing else can be meant. */
private fun operatorOf(token: Token?): BinaryOperator? = when (token?.kind) {
    TokenKind.WORD -> WORD_OPERATORS[token.keyword]
    TokenKind.ASSIGN -> BinaryOperator.EQUAL
    null -> null
    else -> SIGN_OPERATORS[token.text]
}

private val WORD_OPERATORS = mapOf(
    Keyword.OR to BinaryOperator.OR,
    Keyword.AND to BinaryOperator.AND,
    Keyword.MOD to BinaryOperator.MOD,
)

private val SIGN_OPERATORS = BinaryOperator.entries.associateBy { it.text }
