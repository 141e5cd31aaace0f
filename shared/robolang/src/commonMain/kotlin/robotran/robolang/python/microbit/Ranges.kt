package robotran.robolang.python.microbit

import robotran.robolang.check.Symbol
import robotran.robolang.check.ValueType
import robotran.robolang.python.writer.PythonContext
import robotran.robolang.python.writer.ValueSources
import robotran.robolang.syntax.AssignTarget
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.allExpressions
import robotran.robolang.syntax.allStatements

/**
 * Between which limits the whole numbers of a program are, as far as that can be seen: what fits in 32 bits needs no
 * care in Python, nor does a place that a list has.
 *
 * A variable that only counts is taken to be counted less than [ROUNDS] times. That takes a quarter of an hour in a loop
 * that waits or senses, and a minute in one that does nothing else.
 */
internal class Ranges(private val context: PythonContext) {
    private val program = context.program
    private val sources = ValueSources(program)
    private val lengths = ListLengths(program, sources)
    private val elements: List<Expression> = allExpressions(program.tree).filterIsInstance<Expression.ListOf>()
        .flatMap { it.elements } + allStatements(program.tree).filterIsInstance<Statement.Assign>()
        .filter { it.target is AssignTarget.ListElement }.map { it.value }
    private val spans = HashMap<Symbol, Span>()
    private var ofElements: Span? = null
    private val calls = RangesOfCalls(this, lengths)

    init {
        var round = 0
        do {
            val isChanged = update(isLast = round++ > MOST_UPDATES)
        } while (isChanged)
    }

    /** One step; a range that still grows in the [last][isLast] ones is all numbers. */
    private fun update(isLast: Boolean): Boolean {
        var isChanged = false
        for ((symbol, values) in sources.values) {
            if (symbol.type != ValueType.WHOLE) continue
            val all = values + sources.endsOfLoops[symbol].orEmpty()
            val span = all.mapNotNull { sourceSpan(symbol, it) }.reduceOrNull(Span::with)?.inWord()
            if (span == null || span == spans[symbol]) continue
            spans[symbol] = if (isLast) Span.WORD else span
            isChanged = true
        }
        val span = elements.filter { context.expressions.typeOf(it) == ValueType.WHOLE }
            .mapNotNull { known(it) }.reduceOrNull(Span::with)
        if (span != null && span != ofElements && ofElements != Span.WORD) {
            ofElements = if (isLast) Span.WORD else span
            isChanged = true
        }
        return isChanged
    }

    private fun sourceSpan(symbol: Symbol, value: Expression?): Span? = when {
        value == null -> Span.WORD
        spans[symbol] == Span.WORD -> Span.WORD
        else -> counted(symbol, value) ?: known(value)
    }

    /** Of a source such as `x + 1` of x itself. */
    private fun counted(symbol: Symbol, value: Expression): Span? {
        val sum = context.expressions.bare(value) as? Expression.Binary ?: return null
        val step = when {
            sum.operator == BinaryOperator.PLUS && isVariable(sum.left, symbol) -> known(sum.right)
            sum.operator == BinaryOperator.PLUS && isVariable(sum.right, symbol) -> known(sum.left)
            sum.operator == BinaryOperator.MINUS && isVariable(sum.left, symbol) -> known(sum.right)?.negative()
            else -> null
        } ?: return null
        if (step.min < -LARGEST_STEP || step.max > LARGEST_STEP) return null
        val others = sources.values.getValue(symbol).filter { it != null && it != value }
            .mapNotNull { if (isCount(symbol, it)) null else known(checkNotNull(it)) }
        val start = others.reduceOrNull(Span::with) ?: return null
        return Span(start.min + ROUNDS * minOf(0.0, step.min), start.max + ROUNDS * maxOf(0.0, step.max))
    }

    private fun isCount(symbol: Symbol, value: Expression?): Boolean {
        val sum = value?.let { context.expressions.bare(it) } as? Expression.Binary ?: return false
        return isVariable(sum.left, symbol) || isVariable(sum.right, symbol)
    }

    private fun isVariable(expression: Expression, symbol: Symbol): Boolean =
        (context.expressions.bare(expression) as? Expression.Variable)?.let { program.symbolOf(it.name) } == symbol

    /** The range of a whole [expression] as Robolang has it. */
    fun of(expression: Expression): Span = known(expression) ?: Span.WORD

    /** The same before it is brought into 32 bits, of a sum or the like. */
    fun unlimited(expression: Expression): Span = raw(expression) ?: Span.WORD

    /** Whether [index] is a place of [list], whatever happens. */
    fun isPlace(index: Expression, list: Expression): Boolean = lengths.of(list)?.let { isPlace(index, it) } == true

    fun isPlace(index: Expression, list: Symbol): Boolean = lengths.of(list)?.let { isPlace(index, it) } == true

    private fun isPlace(index: Expression, length: IntRange): Boolean =
        of(index).let { it.min >= 0 && it.max < length.first }

    /** Of a symbol whose values are known so far; null if none is. */
    fun ofSymbol(symbol: Symbol): Span? = if (symbol in sources.values) spans[symbol] else Span.WORD

    /** Null as long as nothing is known. */
    fun known(expression: Expression): Span? = raw(expression)?.inWord()

    private fun raw(expression: Expression): Span? = when (expression) {
        is Expression.Number -> ofNumber(expression.value)
        is Expression.Variable -> ofSymbol(program.symbolOf(expression.name))
        is Expression.Brackets -> raw(expression.inner)
        is Expression.Unary -> known(expression.operand)?.negative()
        is Expression.Binary -> ofBinary(expression)
        is Expression.Call -> calls.of(expression, program)
        is Expression.Sense -> calls.of(expression.sense)
        is Expression.ListElement -> ofElements
        is Expression.BooleanLiteral, is Expression.ColourLiteral, is Expression.ListOf -> Span.WORD
    }

    private fun ofNumber(value: NumberValue): Span? =
        (value as? NumberValue.Whole)?.let { Span(it.value.toDouble(), it.value.toDouble()) } ?: Span.WORD

    private fun ofBinary(expression: Expression.Binary): Span? {
        if (program.typeOf(expression) != ValueType.WHOLE) return Span.WORD
        val left = raw(expression.left) ?: return null
        val right = raw(expression.right) ?: return null
        return when (expression.operator) {
            BinaryOperator.PLUS -> left.plus(right)
            BinaryOperator.MINUS -> left.plus(right.negative())
            BinaryOperator.TIMES -> left.times(right)
            BinaryOperator.DIVIDE -> left.inWord().parts(left.inWord().largest)
            BinaryOperator.MOD -> left.inWord().parts(right.inWord().largest - 1)
            else -> Span.WORD
        }
    }

    companion object {
        /** How often a variable is counted at most. */
        const val ROUNDS = 1e6

        /** What is added to a variable that counts, at most. */
        private const val LARGEST_STEP = 100.0

        /** After how many steps a range is given up. */
        private const val MOST_UPDATES = 12
    }
}
