package robotran.tinyvm

import robotran.brick.program.CallFrame
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.program.StatementWatch
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.tinyvm.debug.Inspector
import robotran.tinyvm.link.LinkedMethod
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.TinyVmRunMessages
import robotran.tinyvm.run.Calls
import robotran.tinyvm.run.Failures
import robotran.tinyvm.run.Interpreter
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VirtualMachineConstants
import robotran.tinyvm.run.VmThread

/**
 * One run of a linked program: threads that take turns.
 *
 * @param nativeOf finds what a native method does.
 */
internal abstract class ThreadedRun(
    internal val machine: VirtualMachine,
    messages: TinyVmRunMessages,
    private val bytecodesPerStep: Int,
    nativeOf: (LinkedMethod) -> NativeMethod?,
) : DebuggableRun {
    private val failures = Failures(machine, messages)
    private val calls = Calls(machine, nativesOf(machine.program, nativeOf), failures::add)
    private val interpreter = Interpreter(machine, calls)
    private val inspector = Inspector(machine)
    private var sliceEnds = 0L

    /** Bytecodes to subtract from the next budget: the last overrun, or the used part of an interrupted step. */
    private var debt = 0

    override var watch: StatementWatch?
        get() = interpreter.gate.watch
        set(value) {
            interpreter.gate.watch = value
        }

    override val statementsBegun: Long get() = interpreter.gate.begun

    override val warnings: List<RuntimeWarning> get() = machine.warnings.all

    override val threads: List<ThreadView> get() = machine.scheduler.threads.map {
        inspector.threadView(
            it,
            isCurrent = it === focus,
        )
    }

    override fun activityOf(thread: Int): ThreadActivity? =
        machine.scheduler.threads.find { it.number == thread }?.let { inspector.activityOf(it) }

    override val callStack: List<CallFrame> get() = inspector.callStack(focus)

    override val variables: List<VariableScope> get() = inspector.variables(focus, 0)

    override fun variablesOf(thread: Int, frame: Int): List<VariableScope> =
        inspector.variables(machine.scheduler.threads.find { it.number == thread }, frame)

    override val sourceLine: Int get() = callStack.firstOrNull()?.sourceLine ?: failures.last?.sourceLine ?: 0

    override val sourceFile: String? get() = callStack.firstOrNull()?.sourceFile ?: failures.last?.sourceFile

    override val isBeforeStatement: Boolean get() = inspector.isBeforeStatement(focus)

    override fun isBeforeStatement(thread: Int): Boolean =
        inspector.isBeforeStatement(machine.scheduler.threads.find { it.number == thread })

    /** The thread that the debugger shows: the current one if it is alive, otherwise the first. */
    private val focus: VmThread? get() = machine.current?.takeIf { it.isAlive }
        ?: machine.scheduler.threads.firstOrNull()

    init {
        interpreter.gate.statementOf = inspector::statementOf
        machine.onFailure = failures::add
        machine.startMain()
    }

    override fun resume(steps: Int): ProgramStatus {
        machine.budget =
            (steps.toLong() * bytecodesPerStep - debt).coerceIn(Int.MIN_VALUE.toLong(), Int.MAX_VALUE.toLong()).toInt()
        machine.peripherals.poll()
        val status = runThreads()
        debt =
            if (status is ProgramStatus.Paused) {
                status.stepsLeft * bytecodesPerStep - machine.budget
            } else {
                maxOf(
                    0,
                    -machine.budget,
                )
            }
        return status
    }

    private fun runThreads(): ProgramStatus {
        while (true) {
            when {
                machine.isExited || hasEnded() -> return end()
                machine.budget <= 0 -> return ProgramStatus.Running
            }
            val thread = nextThread() ?: return waitingStatus()
            interpreter.run(thread)
            failures.take()?.let { return ProgramStatus.ThreadFailed(it) }
            if (interpreter.isPaused) {
                return ProgramStatus.Paused((machine.budget + bytecodesPerStep - 1) / bytecodesPerStep)
            }
        }
    }

    /** Whether no thread is left that keeps the program from ending. */
    private fun hasEnded(): Boolean {
        if (machine.scheduler.hasUserThreads) return false
        return machine.scheduler.threads.isEmpty() || !machine.peripherals.delaysEnd()
    }

    private fun nextThread(): VmThread? {
        val current = machine.current
        val continuesCurrent =
            current != null && current.state == ThreadState.READY && !machine.isYielding &&
                machine.milliseconds < sliceEnds
        if (continuesCurrent) return current
        machine.isYielding = false
        machine.charge(machine.model.switchCost(machine.scheduler.threads.size))
        sliceEnds = machine.milliseconds + machine.model.sliceMilliseconds
        return machine.scheduler.choose()?.also {
            machine.current = it
            machine.raiseDueInterrupt(it)
        }
    }

    private fun waitingStatus(): ProgramStatus {
        val now = machine.milliseconds
        val next = machine.scheduler.nextWake ?: (now + VirtualMachineConstants.STANDSTILL_MILLISECONDS)
        val wakesAt = machine.peripherals.wakesAt ?: next
        return ProgramStatus.Waiting(minOf(next, wakesAt))
    }

    private fun end(): ProgramStatus = failures.last?.let { ProgramStatus.Failed(it) } ?: ProgramStatus.Ended

    private fun nativesOf(program: LinkedProgram, nativeOf: (LinkedMethod) -> NativeMethod?): Array<NativeMethod?> =
        Array(program.methods.size) {
            val method = program.methods[it]
            if (method.isNative) nativeOf(method) else null
        }
}
