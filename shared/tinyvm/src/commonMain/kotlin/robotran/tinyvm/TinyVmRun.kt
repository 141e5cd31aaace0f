package robotran.tinyvm

import robotran.brick.program.CallFrame
import robotran.brick.program.DebuggableRun
import robotran.brick.program.ProgramStatus
import robotran.brick.program.RuntimeWarning
import robotran.brick.program.StatementWatch
import robotran.brick.program.ThreadActivity
import robotran.brick.program.ThreadView
import robotran.brick.program.VariableScope
import robotran.rcxrom.program.Rom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.TinyVmCosts
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.debug.Inspector
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.RunMessages
import robotran.tinyvm.natives.NativeMethods
import robotran.tinyvm.run.Calls
import robotran.tinyvm.run.Failures
import robotran.tinyvm.run.Interpreter
import robotran.tinyvm.run.NativeMethod
import robotran.tinyvm.run.ThreadState
import robotran.tinyvm.run.VirtualMachine
import robotran.tinyvm.run.VirtualMachineConstants
import robotran.tinyvm.run.VmThread

/** One run of a linked program. */
internal class TinyVmRun(
    program: LinkedProgram,
    private val rom: Rom,
    mode: TinyVmMode,
    messages: RunMessages,
    speed: TinyVmSpeed,
    version: LejosVersion,
) : DebuggableRun {
    internal val machine = VirtualMachine(program, rom, mode, messages, version)
    private val failures = Failures(machine, messages)
    private val calls = Calls(machine, nativesOf(program), failures::add)
    private val interpreter = Interpreter(machine, calls)
    private val inspector = Inspector(machine)
    private var sliceEnds = 0L

    private val bytecodesPerStep = speed.bytecodesPerStep

    /** Bytecodes to subtract from the next budget: the last overrun, or the used part of an interrupted step. */
    private var debt = 0

    override var watch: StatementWatch?
        get() = interpreter.gate.watch
        set(value) {
            interpreter.gate.watch = value
        }

    override val statementsBegun: Long get() = interpreter.gate.begun

    override val remarks: List<RuntimeWarning> get() = machine.remarks.all

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

    /** The thread that the debugger shows: the current one if it is alive, otherwise the first. */
    private val focus: VmThread? get() = machine.current?.takeIf { it.isAlive }
        ?: machine.scheduler.threads.firstOrNull()

    init {
        interpreter.gate.statementOf = inspector::statementOf
        machine.startMain()
    }

    override fun resume(steps: Int): ProgramStatus {
        machine.budget =
            (steps.toLong() * bytecodesPerStep - debt).coerceIn(Int.MIN_VALUE.toLong(), Int.MAX_VALUE.toLong()).toInt()
        machine.poller.poll()
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
                machine.isExited || !machine.scheduler.hasUserThreads -> return end()
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

    private fun nextThread(): VmThread? {
        val current = machine.current
        val continuesCurrent =
            current != null && current.state == ThreadState.READY && !machine.isYielding && rom.milliseconds < sliceEnds
        if (continuesCurrent) return current
        machine.isYielding = false
        machine.charge(machine.scheduler.threads.size / TinyVmCosts.WORDS_IN_A_BYTECODE)
        sliceEnds = rom.milliseconds + VirtualMachineConstants.TIME_SLICE_MILLISECONDS
        return machine.scheduler.choose()?.also { machine.current = it }
    }

    private fun waitingStatus(): ProgramStatus {
        val now = rom.milliseconds
        val next = machine.scheduler.nextWake ?: (now + VirtualMachineConstants.STANDSTILL_MILLISECONDS)
        return ProgramStatus.Waiting(if (machine.poller.isActive) minOf(next, now + 1) else next)
    }

    private fun end(): ProgramStatus = failures.last?.let { ProgramStatus.Failed(it) } ?: ProgramStatus.Ended

    private fun nativesOf(program: LinkedProgram): Array<NativeMethod?> = Array(program.methods.size) {
        val method = program.methods[it]
        if (method.isNative) NativeMethods.find(method) else null
    }
}
