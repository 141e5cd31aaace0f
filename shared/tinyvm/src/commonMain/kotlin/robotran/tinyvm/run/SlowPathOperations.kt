package robotran.tinyvm.run

import robotran.tinyvm.link.Operation

/** The operations that are too rare for the interpreter's loop. */
internal class SlowPathOperations(machine: VirtualMachine, calls: Calls) {
    private val arithmetic = RcxArithmetic(machine)
    val places = ArrayAddressing(machine, arithmetic)
    val division = Division(arithmetic, calls)
    private val numbers = NumberOperations(machine, arithmetic)
    private val objects = ObjectOperations(machine, calls, places)
    private val exact = NxtOperations(machine, calls, places)

    /** Executes [operation] for [thread]; its operands start at `next` of [frame]. */
    fun execute(thread: VmThread, frame: Frame, operation: Int) {
        if (operation >= Operation.FIRST_EXACT) {
            exact.execute(thread, frame, operation)
        } else if (!numbers.execute(frame, thread.stack, operation)) {
            objects.execute(thread, frame, operation)
        }
    }
}
