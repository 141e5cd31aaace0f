package robotran.tinyvm.run

/** A method of the class library that the machine itself does. */
internal fun interface NativeMethod {
    /**
     * Does it for [thread], whose stack holds the arguments from [first] on, `this` among them, long and double in two
     * words of which the first counts. Returns the result's word, anything if there is none. It throws by
     * [VirtualMachine.raise].
     */
    fun call(machine: VirtualMachine, thread: VmThread, first: Int): Int
}

/** A method that returns nothing. */
internal fun action(act: (machine: VirtualMachine, thread: VmThread, first: Int) -> Unit) =
    NativeMethod { machine, thread, first ->
        act(machine, thread, first)
        0
    }

internal fun wordOf(truth: Boolean): Int = if (truth) 1 else 0
