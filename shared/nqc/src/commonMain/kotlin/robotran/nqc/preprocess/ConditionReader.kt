package robotran.nqc.preprocess

import robotran.nqc.config.NqcLimits
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.syntax.Token
import robotran.nqc.syntax.TokenKind

/** Computes the condition of an `#if` from its [tokens], whose macros are replaced but for those in `defined(..)`. */
internal class ConditionReader(private val tokens: List<Token>, private val isDefined: (String) -> Boolean) {
    /** What is wrong with the condition; null if nothing is. */
    var fault: NqcDiagnosticCode? = null
        private set

    private var place = 0
    private var depth = 0

    /** The value; 0 if the condition has a mistake. */
    fun read(): Int {
        val value = binary(0)
        if (fault == null && place < tokens.size) {
            fault = if (isSign(")")) NqcDiagnosticCode.CONDITION_BRACKETS else NqcDiagnosticCode.CONDITION_SYNTAX
        }
        return if (fault == null) value else 0
    }

    private fun binary(lowest: Int): Int {
        var left = unary()
        while (fault == null && place < tokens.size) {
            val operator = tokens[place].takeIf { it.kind == TokenKind.SIGN }?.text ?: break
            val precedence = PRECEDENCE[operator]?.takeIf { it >= lowest } ?: break
            place++
            left = compute(operator, left, binary(precedence + 1))
        }
        return left
    }

    private fun unary(): Int {
        val token = tokens.getOrNull(place)
        if (token == null || ++depth > NqcLimits.EXPRESSION_HEIGHT) {
            fail(if (token == null) NqcDiagnosticCode.CONDITION_INCOMPLETE else NqcDiagnosticCode.CONDITION_SYNTAX)
            return 0
        }
        place++
        val value = when {
            token.kind == TokenKind.NUMBER -> token.value
            token.kind == TokenKind.NAME -> if (token.text == DEFINED) defined() else 0
            token.isSign("-") -> -unary()
            token.isSign("!") -> if (unary() == 0) 1 else 0
            token.isSign("~") -> unary().inv()
            token.isSign("(") -> inBrackets()
            else -> fail(NqcDiagnosticCode.CONDITION_SYNTAX)
        }
        depth--
        return value
    }

    private fun inBrackets(): Int {
        val value = binary(0)
        if (!isSign(")")) {
            fail(if (place < tokens.size) NqcDiagnosticCode.CONDITION_SYNTAX else NqcDiagnosticCode.CONDITION_BRACKETS)
        }
        place++
        return value
    }

    private fun defined(): Int {
        val name = tokens.getOrNull(place + 1)?.takeIf { it.kind == TokenKind.NAME }
        val isInBrackets = isSign("(") && tokens.getOrNull(place + 2)?.isSign(")") == true
        if (name == null || !isInBrackets) return fail(NqcDiagnosticCode.CONDITION_SYNTAX)
        place += DEFINED_TOKENS
        return if (isDefined(name.text)) 1 else 0
    }

    private fun compute(operator: String, left: Int, right: Int): Int = when (operator) {
        "*" -> left * right
        "/" -> if (right == 0) fail(NqcDiagnosticCode.CONDITION_SYNTAX) else left / right
        "%" -> if (right == 0) fail(NqcDiagnosticCode.CONDITION_SYNTAX) else left % right
        "+" -> left + right
        "-" -> left - right
        "<<" -> left shl right
        ">>" -> left shr right
        ">" -> number(left > right)
        "<" -> number(left < right)
        ">=" -> number(left >= right)
        "<=" -> number(left <= right)
        "==" -> number(left == right)
        "!=" -> number(left != right)
        "&" -> left and right
        "^" -> left xor right
        "|" -> left or right
        "&&" -> number(left != 0 && right != 0)
        else -> number(left != 0 || right != 0)
    }

    private fun number(isTrue: Boolean) = if (isTrue) 1 else 0

    private fun isSign(sign: String) = tokens.getOrNull(place)?.isSign(sign) == true

    private fun fail(code: NqcDiagnosticCode): Int {
        if (fault == null) fault = code
        return 0
    }

    companion object {
        const val DEFINED = "defined"

        /** The tokens of `(NAME)`. */
        private const val DEFINED_TOKENS = 3

        private val PRECEDENCE = listOf(
            listOf("||"),
            listOf("&&"),
            listOf("|"),
            listOf("^"),
            listOf("&"),
            listOf("==", "!="),
            listOf("<", ">", "<=", ">="),
            listOf("<<", ">>"),
            listOf("+", "-"),
            listOf("*", "/", "%"),
        ).flatMapIndexed { level, operators -> operators.map { it to level } }.toMap()
    }
}
