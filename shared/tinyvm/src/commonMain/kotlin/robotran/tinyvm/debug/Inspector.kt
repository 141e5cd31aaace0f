package robotran.tinyvm.debug

import robotran.brick.program.CallFrame
import robotran.brick.program.DebugStatement
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.brick.program.VariableView
import robotran.tinyvm.link.LinkedClass
import robotran.tinyvm.run.Frame
import robotran.tinyvm.run.Heap
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VmThread

/** Describes the state of a run in terms of its source. It never changes the run. */
internal class Inspector(private val machine: VirtualMachine) {
    private val values = ValueTexts(machine)

    fun threadView(thread: VmThread, isCurrent: Boolean) = ThreadView(
        thread.number,
        if (thread.isMain) "main" else (machine.heap.typeOf(thread.reference) as LinkedClass).sourceName,
        thread.priority,
        thread.isDaemon,
        activityOf(thread),
        callStack(thread),
        isCurrent,
    )

    fun activityOf(thread: VmThread): ThreadActivity = when (thread.state) {
        ThreadState.SLEEPING -> ThreadActivity.SLEEPING
        ThreadState.WAITING, ThreadState.JOINING -> ThreadActivity.WAITING_FOR_NOTIFICATION
        ThreadState.BLOCKED -> ThreadActivity.WAITING_FOR_MONITOR
        else -> ThreadActivity.RUNNABLE
    }

    /** The statement on [line] that [thread] is about to begin. */
    fun statementOf(thread: VmThread, line: Int): DebugStatement {
        val depth = thread.callStack.count { it.method.owner.isOfProgram } - 1
        return DebugStatement(line, depth, thread.number, thread.frame.method.owner.sourceFile)
    }

    /**
     * Whether [thread] is about to begin a statement. A waiting thread is still inside the statement in which it waits.
     */
    fun isBeforeStatement(thread: VmThread?): Boolean =
        thread != null && thread.depth > 0 && thread.state == ThreadState.READY && thread.frame.isBeforeStatement

    /** The program's own methods on the call stack of [thread], innermost first. */
    fun callStack(thread: VmThread?): List<CallFrame> = ownFrames(thread).map {
        val line = if (it === thread?.frame && isBeforeStatement(thread)) it.upcomingLine else it.line
        CallFrame(nameOf(it), line, it.method.owner.sourceFile)
    }

    /**
     * The variables of the program's own method at [index] on the call stack of [thread]: its locals, the fields of
     * `this`, but for those of Thread, which belong to the firmware, and the static fields of its class.
     */
    fun variables(thread: VmThread?, index: Int): List<VariableScope> {
        val frame = ownFrames(thread).getOrNull(index) ?: return emptyList()
        val owner = frame.method.owner
        val statics = owner.fields.filter {
            it.isStatic
        }.map { VariableView(it.name, values.of(it.descriptor, machine.statics, it.slot)) }
        return listOf(
            VariableScope(nameOf(frame), locals(thread, frame)),
            VariableScope("this", fieldsOfThis(thread, frame)),
            VariableScope(owner.sourceName, statics),
        ).filter { it.variables.isNotEmpty() }
    }

    private fun locals(thread: VmThread?, frame: Frame): List<VariableView> = frame.body.variablesAt(frame.next)
        .filter { it.name != "this" && it.slot < frame.method.maxLocals }
        .map { VariableView(it.name, values.of(it.descriptor, thread?.stack ?: NO_WORDS, frame.base + it.slot)) }

    private fun fieldsOfThis(thread: VmThread?, frame: Frame): List<VariableView> {
        if (frame.method.isStatic || thread == null) return emptyList()
        val reference = thread.stack[frame.base]
        val type = frame.method.owner
        if (!machine.heap.isObject(reference) || !machine.heap.typeOf(reference).isA(type)) return emptyList()
        return generateSequence(type) {
            it.superclass
        }.filter { it !== machine.program.thread }.toList().asReversed().flatMap { it.fields }.filter { !it.isStatic }
            .map {
                VariableView(
                    it.name,
                    values.of(it.descriptor, machine.heap.words, reference + Heap.HEADER_WORDS + it.slot),
                )
            }
    }

    private fun ownFrames(thread: VmThread?): List<Frame> = thread?.callStack.orEmpty().filter {
        it.method.owner.isOfProgram
    }

    private fun nameOf(frame: Frame): String = when (frame.method.name) {
        "<init>" -> "new ${frame.method.owner.sourceName}"
        "<clinit>" -> "static ${frame.method.owner.sourceName}"
        else -> "${frame.method.owner.sourceName}.${frame.method.name}"
    }

    private companion object {
        val NO_WORDS = IntArray(0)
    }
}
