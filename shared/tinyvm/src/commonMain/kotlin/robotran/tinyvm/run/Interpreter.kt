package robotran.tinyvm.run

/** Executes one thread until the budget is used up, the thread cannot continue, or the debugger pauses it before a statement. */
internal class Interpreter(private val machine: VirtualMachine, calls: Calls) {
    private val threadStarter = ThreadStarter(machine, calls)

    /** Decides before each statement whether to pause. */
    val gate = StatementGate()

    private val code = CodeInterpreter(machine, calls, gate)

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
                else -> isPaused = code.execute(thread)
            }
        }
    }
}
