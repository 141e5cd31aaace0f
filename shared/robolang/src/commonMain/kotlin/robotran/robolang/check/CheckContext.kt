package robotran.robolang.check

import robotran.brick.kind.BrickKind
import robotran.language.source.SourceFix
import robotran.language.source.SourceRange
import robotran.robolang.diagnostic.DiagnosticCode
import robotran.robolang.diagnostic.DiagnosticSink
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Name
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.ParsedProgram
import robotran.robolang.syntax.Routine
import robotran.robolang.syntax.TokenKind
import robotran.robolang.syntax.UnaryOperator
import robotran.robolang.syntax.declaredNames
import robotran.robolang.syntax.shortened
import robotran.robolang.words.Keyword
import robotran.robolang.words.lowercaseKeyword

/** The shared state of the checkers: the program, the symbols and types so far, and the diagnostics. */
internal class CheckContext(val parsed: ParsedProgram, val diagnostics: DiagnosticSink) {
    val messages = diagnostics.messages

    /** The brick that the program is for. */
    val brick: BrickKind get() = diagnostics.brick
    val tree = parsed.tree
    val drafts = mutableListOf<UnresolvedSymbol>()
    val draftsByName = mutableMapOf<SourceRange, UnresolvedSymbol>()
    val routines = mutableMapOf<String, UnresolvedSymbol>()
    val routinesByName = mutableMapOf<SourceRange, Routine>()

    /** The initial value of each variable, by the range of its name. */
    val declaredValues = mutableMapOf<SourceRange, Expression>()
    val calls = mutableListOf<RoutineCall>()
    val nodes = mutableMapOf<SourceRange, TypeNode>()

    /** The number of suggestions searched so far. */
    var suggestions = 0

    /** Lines with syntax errors. */
    val errorLines: Set<Int> = diagnostics.lines.toSet()

    /** Words that may be declared on a line with a syntax error; their uses are not reported. */
    private val excused: Set<String> = errorLines.flatMapTo(mutableSetOf()) { line ->
        val tokens = parsed.lines[line - 1].tokens
        tokens.filter { it.kind == TokenKind.WORD }.map { lowercaseKeyword(it.text) } + declaredNames(tokens)
    }

    /** All names of the program if its block structure is uncertain. */
    private val uncertain: Set<String> = if (parsed.isUncertain) declaredSomewhere() else emptySet()

    fun isExcused(name: Name): Boolean = name.key in excused || name.key in uncertain

    private fun declaredSomewhere(): Set<String> = parsed.lines.flatMapTo(mutableSetOf()) { line ->
        val first = line.tokens.firstOrNull()
        if (first?.keyword in
            DECLARING
        ) {
            line.tokens.filter { it.canBeName }.map { lowercaseKeyword(it.text) }
        } else {
            emptyList()
        }
    }

    /** The routine [name], if there is one. */
    fun routineOf(name: Name): Routine? = draftsByName[name.range]?.let { routinesByName[it.name.range] }

    fun typeOf(expression: Expression): ValueType = nodes[expression.range]?.type ?: ValueType.NOTHING

    fun textOf(range: SourceRange): String = parsed.lines[range.line - 1].text.substring(
        range.column - 1,
        range.endColumn - 1,
    )

    fun quotable(expression: Expression): String = shortened(textOf(expression.range))

    fun report(code: DiagnosticCode, range: SourceRange, message: String, fix: SourceFix? = null) {
        diagnostics.report(code, range, textOf(range), message, fix)
    }

    fun warn(code: DiagnosticCode, range: SourceRange, message: String, fix: SourceFix? = null) {
        diagnostics.warn(code, range, textOf(range), message, fix)
    }

    /** The value of [expression] if it is a known constant; otherwise null. */
    fun constantOf(expression: Expression): NumberValue? = when (expression) {
        is Expression.Number -> expression.value
        is Expression.Brackets -> constantOf(expression.inner)
        is Expression.Variable -> draftsByName[expression.name.range]?.constant

        is Expression.Unary -> if (expression.operator == UnaryOperator.MINUS) {
            constantOf(expression.operand)?.let(::negated)
        } else {
            null
        }

        else -> null
    }

    private fun negated(value: NumberValue): NumberValue = when (value) {
        is NumberValue.Whole -> NumberValue.Whole(-value.value)
        is NumberValue.Decimal -> NumberValue.Decimal(-value.decimal)
    }

    private companion object {
        val DECLARING = setOf(
            Keyword.VAR,
            Keyword.CONST,
            Keyword.FOR,
            Keyword.PROCEDURE,
            Keyword.FUNCTION,
        )
    }
}
