package robotran.nqc.generate

import robotran.legofirmware.instructions.Relation
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.LeaveKind
import robotran.nqc.tree.Statement

/** Generates the code of `if` and `switch`. */
internal class BranchEmitter(private val emitter: Emitter, private val statements: StatementEmitter) {
    private val buffer = emitter.buffer
    private val sink = emitter.sink

    fun branch(statement: Statement.If, frame: FrameLayout) {
        val condition = statements.value(statement.condition, frame)
        val constant = condition.constant
        if (constant != null) {
            val dead = if (constant != 0) statement.otherwise else statement.then
            if (dead == null || !frame.mustEmit(dead)) {
                val taken = if (constant != 0) statement.then else statement.otherwise
                taken?.let { statements.emit(it, frame) }
                return
            }
        }
        val otherwise = buffer.label()
        statements.values.branch(condition, otherwise, isWanted = false)
        statements.emit(statement.then, frame)
        if (statement.otherwise == null) return buffer.place(otherwise)
        val out = buffer.label()
        emitter.jump(out)
        buffer.place(otherwise)
        statements.emit(statement.otherwise, frame)
        buffer.place(out)
    }

    /** Tests all cases in their order, then come the bodies. */
    fun switch(statement: Statement.Switch, frame: FrameLayout) {
        val selector = statements.values.constrained(statements.value(statement.selector, frame)) { it == VARIABLE }
        val labels = HashMap<Statement.Case, Label>()
        val end = buffer.label()
        var default = end
        val seen = HashSet<Int?>()
        for (case in casesIn(statement.body)) {
            if (!seen.add(case.value)) {
                emitter.report(NqcDiagnosticCode.DUPLICATE_CASE, case.range, sink.messages.duplicateCase(case.value))
            }
            val label = buffer.label()
            labels[case] = label
            if (case.value == null) {
                default = label
            } else {
                emitter.test(Emitter.constant(case.value), Relation.EQUAL, selector, label)
            }
        }
        emitter.release(selector)
        emitter.jump(default)
        frame.switches += labels
        statements.flow.within(LeaveKind.BREAK) { (out) ->
            statements.emit(statement.body, frame)
            buffer.place(out)
        }
        frame.switches.removeAt(frame.switches.lastIndex)
        buffer.place(end)
    }

    /** The cases of a `switch` with this [body], without those of a `switch` in it. */
    private fun casesIn(body: Statement): List<Statement.Case> = when (body) {
        is Statement.Switch -> emptyList()
        is Statement.Case -> listOf(body) + casesIn(body.body)
        else -> body.parts.flatMap { casesIn(it) }
    }

    fun case(statement: Statement.Case, frame: FrameLayout) {
        val label = frame.switches.lastOrNull()?.get(statement)
        if (label == null) {
            emitter.report(NqcDiagnosticCode.CASE_OUTSIDE_SWITCH, statement.range, sink.messages.caseOutsideSwitch())
        } else {
            buffer.place(label)
        }
        statements.emit(statement.body, frame)
    }

    private companion object {
        /** The source of variables. */
        const val VARIABLE = 0
    }
}
