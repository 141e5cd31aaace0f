package robotran.robolang.translate

import robotran.robolang.check.CheckedProgram
import robotran.robolang.syntax.BinaryOperator
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement

/** Writes loops. */
internal class JavaLoops(
    private val program: CheckedProgram,
    private val names: JavaNames,
    private val expressions: JavaExpressions,
    private val writer: JavaWriter,
    private val block: (List<Statement>) -> Unit,
) {
    private val flow = JavaFlow(program)
    private val steady = InvariantExpressions(program)

    fun write(loop: Statement.Loop) {
        // A list variable that may change during the loop is copied to another variable before it.
        val list = (loop as? Statement.ForEach)?.let(::fixedList)
        names.inScope {
            when (loop) {
                is Statement.Repeat -> repeat(loop)
                is Statement.RepeatForever -> around(loop, "while (true)")
                is Statement.RepeatWhile -> asLongAs(loop, loop.condition, isOpposite = false)
                is Statement.RepeatUntil -> asLongAs(loop, loop.condition, isOpposite = true)
                is Statement.ForRange -> forRange(loop)
                is Statement.ForEach -> forEach(loop, list.orEmpty())
            }
        }
    }

    private fun repeat(loop: Statement.Repeat) {
        val count = expressions.text(loop.count)
        if (steady.isSteady(loop.count)) {
            val round = names.local("lap")
            around(loop, "for (int $round = 0; $round < ${operand(loop.count)}; $round++)")
        } else {
            val rounds = names.local("laps")
            around(loop, "for (int $rounds = $count; $rounds > 0; $rounds--)")
        }
    }

    /** A loop while [condition] holds, or, if [isOpposite], while it does not. */
    private fun asLongAs(loop: Statement.Loop, condition: Expression, isOpposite: Boolean) {
        if (flow.isEndless(loop)) {
            around(loop, "while (true)")
        } else if (flow.isConstant(condition)) {
            writer.open("while (true)", loop.range.line)
            writer.line("if (${text(condition, !isOpposite)}) break;", loop.range.line)
            finish(loop)
        } else {
            around(loop, "while (${text(condition, isOpposite)})")
        }
    }

    private fun text(condition: Expression, isOpposite: Boolean): String =
        if (isOpposite) expressions.opposite(condition) else expressions.text(condition)

    private fun forRange(loop: Statement.ForRange) {
        val symbol = program.symbolOf(loop.variable)
        val from = expressions.text(loop.from)
        val to = expressions.text(loop.to)
        val stepText = loop.step?.let { expressions.text(it) }
        val variable = names.declareLocal(symbol)
        val start = StringBuilder("${javaType(symbol.type)} $variable = $from")
        val last = if (steady.isSteady(loop.to)) {
            operand(loop.to)
        } else {
            names.local("last").also {
                start.append(", $it = $to")
            }
        }
        val step = valueOfStep(loop.step)
        if (step != null) {
            val count = steady.countBehind(loop.to).takeIf { loop.step == null }
            val condition = when {
                count != null -> "$variable < ${operand(count)}"
                step.isNegative -> "$variable >= $last"
                else -> "$variable <= $last"
            }
            around(loop, "for ($start; $condition; ${advance(variable, stepText, step)})", names.noteOn(symbol))
        } else {
            val by = names.local("step").also { start.append(", $it = $stepText") }
            val condition = "$by > 0 ? $variable <= $last : $variable >= $last"
            around(loop, "for ($start; $condition; $variable += $by)", names.noteOn(symbol))
        }
    }

    /** [expression] as an operand of `<`. */
    private fun operand(expression: Expression): String = expressions.text(
        expression,
        OperatorPrecedence.of(BinaryOperator.LESS) + 1,
    )

    /** The step if it is a literal, which determines the direction. */
    private fun valueOfStep(step: Expression?): NumberValue? = when (step) {
        null -> NumberValue.Whole(1)
        is Expression.Number -> step.value
        else -> null
    }

    /** leJOS's linker refuses `number += 200` of a local variable, which compilers make a single wide instruction. */
    private fun advance(variable: String, step: String?, value: NumberValue): String {
        val by = step.orEmpty().removePrefix("-")
        val operator = if (step.orEmpty().startsWith("-")) "-" else "+"
        val isLarge = value is NumberValue.Whole && value.value !in SHORT_STEPS
        return when {
            step == null || step == "1" -> "$variable++"
            step == "-1" -> "$variable--"
            isLarge -> "$variable = $variable $operator $by"
            else -> "$variable $operator= $by"
        }
    }

    private fun forEach(loop: Statement.ForEach, list: String) {
        val symbol = program.symbolOf(loop.variable)
        val position = names.local("position")
        writer.open("for (int $position = 0; $position < $list.length; $position++)", loop.range.line)
        val variable = names.declareLocal(symbol)
        writer.line("${javaType(symbol.type)} $variable = $list[$position];", loop.range.line, names.noteOn(symbol))
        finish(loop)
    }

    /** The name of the list of [loop], which stays the same during the loop. */
    private fun fixedList(loop: Statement.ForEach): String {
        val list = loop.list
        val symbol = (list as? Expression.Variable)?.let { program.symbolOf(it.name) }
        if (symbol != null && steady.isSteady(list)) return names.of(symbol)
        val value = if (list is Expression.ListOf) expressions.elements(list) else expressions.text(list)
        val name = names.local("elements")
        writer.line("${javaType(expressions.typeOf(list))} $name = $value;", loop.range.line)
        return name
    }

    private fun around(loop: Statement.Loop, opening: String, note: String? = null) {
        writer.open(opening, loop.range.line, note)
        finish(loop)
    }

    private fun finish(loop: Statement.Loop) {
        if (program.tree.behaviours.isNotEmpty()) writer.line("giveWay();")
        block(loop.body)
        writer.close(loop.endRange.line)
    }

    private companion object {
        /** What the brick adds to a local variable in one instruction. */
        val SHORT_STEPS = -128..127
    }
}
