package robotran.robolang.nqc

import robotran.robolang.check.CheckedProgram
import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.NumberValue
import robotran.robolang.syntax.Statement

/** Writes loops. The variable of a `for` belongs to the block around in NQC. */
internal class NqcLoops(
    private val program: CheckedProgram,
    private val names: NqcNames,
    private val expressions: NqcExpressions,
    private val lists: KnownLists,
    private val notes: TranslationNotes,
    private val statements: NqcStatements,
) {
    fun write(loop: Statement.Loop) = when (loop) {
        is Statement.Repeat -> around(loop) { "repeat (${expressions.text(loop.count)})" }
        is Statement.RepeatForever -> around(loop) { "while (true)" }
        is Statement.RepeatWhile -> asLongAs(loop, loop.condition, isOpposite = false)
        is Statement.RepeatUntil -> asLongAs(loop, loop.condition, isOpposite = true)
        is Statement.ForRange -> forRange(loop)
        is Statement.ForEach -> forEach(loop)
    }

    private fun around(loop: Statement.Loop, head: () -> String) =
        statements.around(loop.range.line, loop.endRange.line, head) { statements.block(loop.body) }

    private fun lost(loop: Statement.Loop, message: String) {
        statements.lines(loop.range.line) {
            notes.lost(loop.range, message)
            emptyList()
        }
    }

    private fun asLongAs(loop: Statement.Loop, condition: Expression, isOpposite: Boolean) {
        val (_, calls) = statements.condition(condition, isOpposite)
        if (calls.isEmpty()) {
            around(loop) { (if (isOpposite) "until" else "while") + " (${expressions.text(condition)})" }
            return
        }
        // A function must be called in each round.
        statements.around(loop.range.line, loop.endRange.line, { "while (true)" }) {
            statements.lines(loop.range.line) {
                listOf("if (${statements.text(condition, !isOpposite)}) break;")
            }
            statements.block(loop.body)
        }
    }

    private fun forEach(loop: Statement.ForEach) {
        val list = expressions.bare(loop.list)
        val symbol = program.symbolOf(loop.variable)
        val size = (list as? Expression.ListOf)?.elements?.size ?: lists.sizeOf(list)
        if (size == null || symbol.type != ValueType.WHOLE) return lost(loop, notes.messages.list())
        var variable = ""
        var array = ""
        val place = names.local("place")
        val isComplete = statements.lines(loop.range.line) {
            val own = (list as? Expression.ListOf)?.let { names.local("list") }
            array = own ?: names.of(program.symbolOf((list as Expression.Variable).name))
            variable = names.declareLocal(symbol)
            val declared = listOfNotNull(own?.let { "int $it[$size];" }) + "int $place, $variable;"
            declared + if (own != null) statements.elements(own, list) else emptyList()
        }
        if (!isComplete) return
        statements.around(
            loop.range.line,
            loop.endRange.line,
            { "for ($place = 0; $place < $size; $place++)" },
        ) {
            statements.lines(loop.range.line) { listOf("$variable = $array[$place];") }
            statements.block(loop.body)
        }
    }

    private fun forRange(loop: Statement.ForRange) {
        val step = when (val written = loop.step?.let { expressions.bare(it) }) {
            null -> 1
            is Expression.Number -> (written.value as? NumberValue.Whole)?.value
            else -> null
        }
        val symbol = program.symbolOf(loop.variable)
        if (symbol.type == ValueType.DECIMAL) return lost(loop, notes.messages.decimal())
        if (step == null || step == 0) return lost(loop, notes.messages.unknownStep())
        var variable = ""
        var from = ""
        var last = ""
        val isComplete = statements.lines(loop.range.line) {
            from = expressions.text(loop.from)
            val written = expressions.wholeOf(loop.to)
            val to = expressions.text(loop.to)
            variable = names.declareLocal(symbol)
            last = if (written == null) names.local("last") else to
            listOfNotNull("int $variable;", if (written == null) "int $last = $to;" else null)
        }
        if (!isComplete) return
        val relation = if (step > 0) "<=" else ">="
        val advance = when (step) {
            1 -> "$variable++"
            -1 -> "$variable--"
            else -> if (step > 0) "$variable += $step" else "$variable -= ${-step}"
        }
        around(loop) { "for ($variable = $from; $variable $relation $last; $advance)" }
    }
}
