package robotran.nqc.generate

import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.Relation
import robotran.nqc.tree.Expression
import robotran.nqc.tree.LeaveKind
import robotran.nqc.tree.Statement
import robotran.nqc.tree.VariableOperation

/** Generates the code of loops. */
internal class LoopEmitter(private val emitter: Emitter, private val statements: StatementEmitter) {
    private val buffer = emitter.buffer

    /** Whether the loop counter of firmware 1.0 is in use: NQC uses only one. */
    private var usesCounter = false

    fun whileLoop(statement: Statement.While, frame: FrameLayout) = loop { again, out ->
        val condition = statements.value(statement.condition, frame)
        val constant = condition.constant
        if (constant != null && constant != 0) {
            buffer.place(again)
            statements.emit(statement.body, frame)
            emitter.jump(again)
        } else if (constant == null || frame.mustEmit(statement.body)) {
            testAtEnd(statement, condition, again, frame)
        }
        buffer.place(out)
    }

    private fun testAtEnd(statement: Statement.While, condition: Expression, again: Label, frame: FrameLayout) {
        val count = buffer.count
        emitter.jump(again)
        val start = buffer.label()
        statements.emit(statement.body, frame)
        if (buffer.count == start.index) {
            buffer.truncate(count)
            buffer.place(start)
        }
        buffer.place(again)
        statements.mark(statement, frame)
        statements.values.branch(condition, start, isWanted = true)
    }

    fun doWhile(statement: Statement.DoWhile, frame: FrameLayout) = loop { again, out ->
        val start = buffer.label()
        statements.emit(statement.body, frame)
        buffer.place(again)
        statements.mark(statement, frame)
        statements.values.branch(statements.value(statement.condition, frame), start, isWanted = true)
        buffer.place(out)
    }

    fun forLoop(statement: Statement.For, frame: FrameLayout) {
        statement.first?.let { statements.emit(it, frame) }
        loop { again, out ->
            val start = buffer.label()
            statements.mark(statement, frame)
            statement.condition?.let { statements.values.branch(statements.value(it, frame), out, isWanted = false) }
            statements.emit(statement.body, frame)
            buffer.place(again)
            statement.step?.let { statements.emit(it, frame) }
            emitter.jump(start)
            buffer.place(out)
        }
    }

    fun repeat(statement: Statement.Repeat, frame: FrameLayout) {
        val count = statements.value(statement.count, frame)
        when {
            emitter.target == FirmwareTarget.RCX2 -> withDecrement(count, statement, frame)
            count.constant in COUNTS && !usesCounter -> withCounter(count, statement, frame)
            else -> withVariable(count, statement, frame)
        }
    }

    private fun withCounter(count: Expression, statement: Statement.Repeat, frame: FrameLayout) = loop { again, out ->
        usesCounter = true
        val place = statements.values.any(count)
        emitter.add(Opcode.LOOPS, place.type, Emitter.low(place.data))
        buffer.place(again)
        emitter.jump(Opcode.LOOPCL, out)
        statements.emit(statement.body, frame)
        emitter.jump(again)
        buffer.place(out)
        usesCounter = false
    }

    private fun withVariable(count: Expression, statement: Statement.Repeat, frame: FrameLayout) = loop { again, out ->
        counted(count) { variable ->
            buffer.place(again)
            emitter.test(Emitter.constant(0), Relation.AT_LEAST, Emitter.variable(variable), out)
            emitter.operation(VariableOperation.SUBTRACT, variable, Emitter.constant(1))
            statements.emit(statement.body, frame)
            emitter.jump(again)
        }
        buffer.place(out)
    }

    private fun withDecrement(count: Expression, statement: Statement.Repeat, frame: FrameLayout) = loop { again, out ->
        counted(count) { variable ->
            buffer.place(again)
            emitter.jump(Opcode.DECVJNL, out, variable)
            statements.emit(statement.body, frame)
            emitter.jump(again)
        }
        buffer.place(out)
    }

    /** Generates [body] with a variable that begins with [count]. */
    private fun counted(count: Expression, body: (Int) -> Unit) {
        val variable = emitter.temporary(count.range)
        statements.values.to(count, variable)
        body(variable)
        emitter.allocator.release(variable)
    }

    /** Generates [body] with the targets of `continue` and `break`. */
    private fun loop(body: (Label, Label) -> Unit) =
        statements.flow.within(LeaveKind.CONTINUE, LeaveKind.BREAK) { (again, out) -> body(again, out) }

    private companion object {
        /** The loop counts that firmware 1.0 can count by itself. */
        val COUNTS = 0..255
    }
}
