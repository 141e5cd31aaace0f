package robotran.robolang.run

import robotran.robolang.check.ValueType
import robotran.robolang.syntax.Expression
import robotran.robolang.syntax.Statement

/**
 * Lowers loops. A loop's counters lie on the stack below the operands of its body and are popped when the loop is left.
 */
internal class LoopLowering(
    private val emitter: Emitter,
    private val expressions: ExpressionLowering,
    private val lowerBody: (List<Statement>) -> Unit,
) {
    private val open = ArrayDeque<OpenLoop>()

    fun lower(statement: Statement.Loop) = emitter.inBlock {
        val line = statement.range.line
        when (statement) {
            is Statement.Repeat -> lowerRepeat(statement, line)
            is Statement.RepeatForever -> rounds(line, statement.body) { }

            is Statement.RepeatWhile -> rounds(line, statement.body) { end ->
                expressions.lower(statement.condition)
                emitter.jumpIfFalse(end)
            }

            is Statement.RepeatUntil -> rounds(line, statement.body) { end ->
                expressions.lower(statement.condition)
                emitter.jumpIfTrue(end)
            }

            is Statement.ForRange -> lowerForRange(statement, line)
            is Statement.ForEach -> lowerForEach(statement, line)
        }
    }

    /** `break` */
    fun leave() = emitter.jump(open.last().end)

    /** `continue` */
    fun nextRound() = emitter.jump(open.last().round)

    /**
     * A loop whose rounds are all the same: a statement that checks by [look] whether there is another round, and the
     * body.
     */
    private fun rounds(line: Int, body: List<Statement>, look: (end: Label) -> Unit) {
        val loop = OpenLoop()
        emitter.put(loop.round)
        emitter.statement(line)
        look(loop.end)
        lowerBody(loop, body)
    }

    private fun lowerRepeat(statement: Statement.Repeat, line: Int) {
        val first = Label()
        val loop = OpenLoop()
        emitter.statement(line)
        expressions.lower(statement.count)
        emitter.emit { if (it.peek() < 0) fail(it.machine.messages.negativeCount(it.peek())) }
        emitter.jump(first)
        emitter.put(loop.round)
        emitter.statement(line)
        emitter.put(first)
        emitter.emit {
            if (it.peek() > 0) it.replace(it.peek() - 1) else it.next = loop.end.place
        }
        lowerBody(loop, statement.body)
        emitter.drop(1)
    }

    private fun lowerForRange(statement: Statement.ForRange, line: Int) {
        val type = expressions.typeOf(statement.variable)
        val arithmetic = expressions.arithmeticOf(type)
        val first = Label()
        val loop = OpenLoop()
        emitter.statement(line)
        expressions.lower(statement.from, type)
        expressions.store(statement.variable)
        expressions.lower(statement.to, type)
        lowerStep(statement.step, type)
        emitter.emit { if (arithmetic.sign(it.peek()) == 0) fail(it.machine.messages.stepOfNothing()) }
        emitter.jump(first)
        expressions.declare(statement.variable)
        emitter.put(loop.round)
        emitter.statement(line)
        expressions.load(statement.variable)
        emitter.emit { it.push(arithmetic.plus(it.pop(), it.peek(), it.machine.messages)) }
        expressions.store(statement.variable)
        emitter.put(first)
        expressions.load(statement.variable)
        emitter.emit {
            val value = it.pop()
            val limit = it.peek(below = 1)
            val isOver = if (arithmetic.sign(it.peek()) > 0) {
                arithmetic.isLess(limit, value)
            } else {
                arithmetic.isLess(value, limit)
            }
            if (isOver) it.next = loop.end.place
        }
        lowerBody(loop, statement.body)
        emitter.drop(2)
    }

    private fun lowerStep(step: Expression?, type: ValueType) {
        if (step != null) return expressions.lower(step, type)
        if (type == ValueType.DECIMAL) emitter.emit { it.pushDecimal(1f) } else emitter.emit { it.push(1) }
    }

    private fun lowerForEach(statement: Statement.ForEach, line: Int) {
        val first = Label()
        val loop = OpenLoop()
        emitter.statement(line)
        expressions.lower(statement.list)
        emitter.emit { it.push(-1) }
        emitter.jump(first)
        expressions.declare(statement.variable)
        emitter.put(loop.round)
        emitter.statement(line)
        emitter.put(first)
        emitter.emit {
            val place = it.peek() + 1
            val elements = it.machine.lists.elements(it.peek(below = 1))
            it.replace(place)
            it.push(elements.getOrElse(place) { 0 })
            if (place >= elements.size) {
                it.drop(1)
                it.next = loop.end.place
            }
        }
        expressions.store(statement.variable)
        lowerBody(loop, statement.body)
        emitter.drop(2)
    }

    private fun lowerBody(loop: OpenLoop, body: List<Statement>) {
        open.addLast(loop)
        lowerBody(body)
        open.removeLast()
        emitter.jump(loop.round)
        emitter.put(loop.end)
    }

    private class OpenLoop {
        val round = Label()
        val end = Label()
    }
}
