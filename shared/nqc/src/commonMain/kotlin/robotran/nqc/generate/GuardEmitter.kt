package robotran.nqc.generate

import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.instructions.Opcode
import robotran.legofirmware.instructions.Relation
import robotran.legofirmware.instructions.ValueSource
import robotran.nqc.diagnostic.NqcDiagnosticCode
import robotran.nqc.tree.Handler
import robotran.nqc.tree.Place
import robotran.nqc.tree.Statement
import robotran.nqc.tree.VariableOperation

/** Generates the code of `monitor` and `acquire`. */
internal class GuardEmitter(private val emitter: Emitter, private val statements: StatementEmitter) {
    private val buffer = emitter.buffer
    private val sink = emitter.sink

    fun monitor(statement: Statement.Monitor, frame: FrameLayout) {
        if (emitter.target == FirmwareTarget.RCX) {
            val message = sink.messages.monitorUnsupported()
            return emitter.report(NqcDiagnosticCode.MONITOR_UNSUPPORTED, statement.range, message)
        }
        if (!statements.flow.begin(FlowContext.Guard.MONITOR)) {
            return emitter.report(NqcDiagnosticCode.NESTED_MONITOR, statement.range, sink.messages.nestedMonitor())
        }
        val events = statements.values.any(statements.value(statement.events, frame))
        var next = buffer.label()
        val end = buffer.label()
        val low = Emitter.low(events.data)
        emitter.jump(Opcode.MONEL, next, events.type, low, Emitter.high(events.data))
        emitter.release(events)
        statements.emit(statement.body, frame)
        emitter.add(Opcode.MONEX)
        for (handler in statement.handlers) {
            emitter.jump(end)
            buffer.place(next)
            next = buffer.label()
            if (handler.mask != null) testEvents(handler.mask, next, handler)
            statements.emit(handler.body, frame)
            // What a handler of all events leaves out, nobody handles.
            if (handler.mask == null) next = buffer.label()
        }
        buffer.place(next)
        buffer.place(end)
        statements.flow.end(FlowContext.Guard.MONITOR)
    }

    /** Goes on at [next] if none of the events of [mask] happened. */
    private fun testEvents(mask: Int, next: Label, handler: Handler) {
        val variable = emitter.temporary(handler.range)
        emitter.allocator.release(variable)
        emitter.move(variable, Place(ValueSource.ACTIVE_EVENTS, RUNNING_TASK))
        emitter.operation(VariableOperation.AND, variable, Emitter.constant(mask))
        emitter.test(Emitter.constant(0), Relation.EQUAL, Emitter.variable(variable), next)
    }

    fun acquire(statement: Statement.Acquire, frame: FrameLayout) {
        if (emitter.target == FirmwareTarget.RCX) {
            val message = sink.messages.acquireUnsupported()
            return emitter.report(NqcDiagnosticCode.ACQUIRE_UNSUPPORTED, statement.range, message)
        }
        if (!statements.flow.begin(FlowContext.Guard.ACQUIRE)) {
            return emitter.report(NqcDiagnosticCode.NESTED_ACQUIRE, statement.range, sink.messages.nestedAcquire())
        }
        val handler = buffer.label()
        val end = buffer.label()
        emitter.jump(Opcode.MONAL, handler, Emitter.low(statement.resources))
        statements.emit(statement.body, frame)
        emitter.add(Opcode.MONAX)
        if (statement.handler != null) emitter.jump(end)
        buffer.place(handler)
        statement.handler?.let { statements.emit(it, frame) }
        buffer.place(end)
        statements.flow.end(FlowContext.Guard.ACQUIRE)
    }

    private companion object {
        /** The argument of the active events that means the running task. */
        const val RUNNING_TASK = 10
    }
}
