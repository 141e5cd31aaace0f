package robotran.tinyvm.run

/**
 * Executes one thread until the budget is used up, the thread cannot continue, or the debugger pauses it before a
 * statement. Without a debugger, it executes register code where there is some, and stack code for what that leaves out:
 * what is rare, and the last bytecodes of a budget. Both have the same effects in the same time.
 */
internal class Interpreter(private val machine: VirtualMachine, calls: Calls) {
    private val threadStarter = ThreadStarter(machine, calls)
    private val rare = RareOperations(machine, calls)

    /** Decides before each statement whether to pause. */
    val gate = StatementGate()

    private val stackInterpreter = StackInterpreter(machine, calls, gate, rare)
    private val registerInterpreter = RegisterInterpreter(machine, calls, gate, rare)

    /** Whether [gate] stopped the thread. */
    var isPaused = false
        private set

    /** Continues [thread], which must be ready. */
    fun run(thread: VmThread) {
        isPaused = false
        while (machine.budget > 0 && thread.state == ThreadState.READY && !isPaused && !machine.isYielding &&
            !machine.isExited
        ) {
            when {
                thread.pending != 0 -> threadStarter.throwPending(thread)
                thread.depth == 0 -> threadStarter.begin(thread)
                gate.isWatched -> isPaused = stackInterpreter.execute(thread, stop = 0)
                thread.frame.body.registerCode == null -> executeStackCode(thread, MAX_STACK_BYTECODES)
                else -> executeRegisterCode(thread)
            }
        }
    }

    private fun executeRegisterCode(thread: VmThread) {
        when (registerInterpreter.execute(thread)) {
            RegisterInterpreter.Result.CONTINUE -> Unit
            RegisterInterpreter.Result.NEEDS_STACK_CODE -> executeStackCode(thread, 1)
            RegisterInterpreter.Result.NEEDS_BUDGET -> executeStackCode(thread, machine.budget)
        }
    }

    /** Executes about [bytecodes] of stack code. */
    private fun executeStackCode(thread: VmThread, bytecodes: Int) {
        stackInterpreter.execute(thread, maxOf(0, machine.budget - bytecodes))
    }

    private companion object {
        /** After so many bytecodes of stack code, a method that it has called may have register code. */
        const val MAX_STACK_BYTECODES = 64
    }
}
