package robotran.tinyvm.run

import robotran.tinyvm.link.LinkedClass

/** Prepares a thread before it executes operations: its first call, and throwing a pending exception. */
internal class ThreadStarter(private val machine: VirtualMachine, private val calls: Calls) {
    /** Calls the first method of [thread]. */
    fun begin(thread: VmThread) {
        val main = machine.program.main
        if (thread.isMain) {
            if (calls.begin(thread, main, machine.mainArguments()) && !machine.isInitialized[main.owner.number]) {
                initializeMainClass(thread, main.owner)
            }
        } else {
            val run = machine.heap.typeOf(thread.reference).virtualMethods[machine.program.threadRun.virtualIndex]
            calls.begin(thread, run, thread.reference)
        }
    }

    /** Throws the pending exception. */
    fun throwPending(thread: VmThread) {
        val exception = thread.pending
        thread.pending = 0
        when {
            thread.depth > 0 -> calls.throwObject(thread, exception, isOfNative = true)
            thread.uncaught != 0 -> calls.beginUncaught(thread)
        }
    }

    /** Pushes the initializer above the frame of main, so that it runs first. */
    private fun initializeMainClass(thread: VmThread, type: LinkedClass) {
        while (!machine.isInitialized[type.number] && thread.pending == 0 && thread.depth == 1) {
            calls.initialize(thread, type)
        }
    }
}
