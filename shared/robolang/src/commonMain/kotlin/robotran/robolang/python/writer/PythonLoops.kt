package robotran.robolang.python.writer

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.Command
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement
import robotran.robolang.syntax.expressions
import robotran.robolang.syntax.withParts
import robotran.robolang.translate.InvariantExpressions

/** Writes loops. Those over decimal numbers count by themselves, since `range` only takes whole ones. */
internal class PythonLoops(
    private val program: CheckedProgram,
    private val names: PythonNames,
    private val expressions: PythonExpressions,
    private val target: PythonTarget,
    private val statements: PythonStatements,
) {
    private val steady = InvariantExpressions(program)

    /** What the innermost loop does before each next round. */
    private val beforeNextRound = ArrayDeque<String?>()

    /** Lines to write before `continue`. */
    val onContinue: List<String> get() = listOfNotNull(beforeNextRound.lastOrNull())

    fun write(loop: Statement.Loop) = names.inScope {
        when (loop) {
            is Statement.Repeat -> around(loop) { "for _ in ${target.arithmetic.times(loop)}" }
            is Statement.RepeatForever -> around(loop) { "while True" }
            is Statement.RepeatWhile -> around(loop) { "while ${expressions.text(loop.condition)}" }
            is Statement.RepeatUntil -> around(loop) { "while ${expressions.opposite(loop.condition)}" }
            is Statement.ForRange -> if (isDecimal(loop)) countDecimals(loop) else count(loop)
            is Statement.ForEach -> forEach(loop)
        }
    }

    private fun isDecimal(loop: Statement.ForRange) = program.symbolOf(loop.variable).type == ValueType.DECIMAL

    private fun around(loop: Statement.Loop, next: String? = null, head: () -> String) {
        val isOpen = statements.lines(loop.range.line) {
            val text = head()
            listOf("$text:") to (loop as? Statement.ForRange)?.let { names.noteOn(program.symbolOf(it.variable)) }
        }
        if (!isOpen) return
        beforeNextRound.addLast(next)
        statements.block(loop.body, loop.endRange.line, pauseIn(loop), next)
        beforeNextRound.removeLast()
    }

    /** What keeps a loop that waits for nothing from keeping the robot busy, and others from their turn. */
    private fun pauseIn(loop: Statement.Loop): PythonPause? {
        val isOpenEnded =
            loop is Statement.RepeatForever || loop is Statement.RepeatWhile || loop is Statement.RepeatUntil
        val inner = withInner(loop.body)
        if (inner.any { statements.takesTime(it) }) return null
        val watches = loop is Statement.RepeatForever || inner.any { it is Command } ||
            (loop.expressions + inner.flatMap { it.expressions }).flatMap(::withParts).any { it is Expression.Sense }
        val line = (if (isOpenEnded && watches) target.pause() else target.look()) ?: return null
        val skips = loop.body.any { hasContinue(it) }
        return PythonPause(line, isFirst = skips)
    }

    /** Whether [statement] goes on with the next round of the loop around it. */
    private fun hasContinue(statement: Statement): Boolean = when (statement) {
        is Statement.Continue -> true
        is Statement.Loop -> false
        else -> withInner(listOf(statement)).drop(1).any { hasContinue(it) }
    }

    private fun count(loop: Statement.ForRange) = around(loop) {
        val range = rangeOf(loop)
        "for ${names.declareLocal(program.symbolOf(loop.variable))} in $range"
    }

    private fun rangeOf(loop: Statement.ForRange): String {
        val from = expressions.text(loop.from)
        val step = loop.step
        val by = if (step == null) 1 else (expressions.literal(step) as? NumberValue.Whole)?.value
        if (by == null || by == 0) {
            val arguments = expressions.arguments(listOfNotNull(loop.from, loop.to, step))
            return target.arithmetic.count(loop, arguments)
        }
        val behind = behind(loop.to, if (by > 0) 1 else -1)
        return when {
            by != 1 -> "range($from, $behind, $by)"
            from == "0" -> "range($behind)"
            else -> "range($from, $behind)"
        }
    }

    /** The number behind [last], where `range` ends. */
    private fun behind(last: Expression, sign: Int): String {
        (expressions.literal(last) as? NumberValue.Whole)?.let { return "${it.value.toLong() + sign}" }
        val difference = expressions.bare(last) as? Expression.Binary
        val undoes = if (sign > 0) BinaryOperator.MINUS else BinaryOperator.PLUS
        if (difference?.operator == undoes && expressions.literal(difference.right) == NumberValue.Whole(1)) {
            return expressions.text(difference.left)
        }
        return "${expressions.text(last, PythonStrength.SUM)} ${if (sign > 0) "+" else "-"} 1"
    }

    private fun countDecimals(loop: Statement.ForRange) {
        val symbol = program.symbolOf(loop.variable)
        val step = loop.step
        val known = if (step == null) NumberValue.Whole(1) else expressions.literal(step)
        var variable = ""
        var last = ""
        var by = step?.let { expressions.text(it) } ?: "1"
        val isBegun = statements.lines(loop.range.line) {
            val from = expressions.text(loop.from, ValueType.DECIMAL)
            val to = expressions.text(loop.to, PythonStrength.SUM)
            variable = names.declareLocal(symbol)
            last = if (steady.isSteady(loop.to)) to else names.local("last")
            if (known == null) by = names.local("step")
            val others = listOfNotNull(
                "$last = ${expressions.text(loop.to)}".takeIf { last != to },
                step?.takeIf { known == null }?.let { "$by = ${target.arithmetic.step(loop, expressions.text(it))}" },
            )
            (listOf("$variable = $from") + others) to names.noteOn(symbol)
        }
        if (!isBegun) return
        val next = if (by.startsWith("-")) "$variable = $variable - ${by.drop(1)}" else "$variable = $variable + $by"
        around(loop, next) {
            when {
                known == null -> "while $variable <= $last if $by > 0 else $variable >= $last"
                known.isNegative -> "while $variable >= $last"
                else -> "while $variable <= $last"
            }
        }
    }

    private fun forEach(loop: Statement.ForEach) = around(loop) {
        val list = expressions.text(loop.list)
        "for ${names.declareLocal(program.symbolOf(loop.variable))} in $list"
    }
}
