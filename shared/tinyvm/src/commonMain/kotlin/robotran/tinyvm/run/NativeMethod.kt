package robotran.tinyvm.run

/** A method of the class library that the virtual machine implements. */
internal fun interface NativeMethod {
    /**
     * Executes the method for [thread]. Its stack holds the arguments from index [first], including `this`; a long or
     * double takes two words, of which the first holds the value. Returns the result word, which is ignored if the
     * method has no result. Throws through [VirtualMachine.raise].
     */
    fun call(machine: VirtualMachine, thread: VmThread, first: Int): Int
}

/** Creates a native method that returns nothing. */
internal fun action(act: (machine: VirtualMachine, thread: VmThread, first: Int) -> Unit) =
    NativeMethod { machine, thread, first ->
        act(machine, thread, first)
        0
    }

internal fun wordOf(truth: Boolean): Int = if (truth) 1 else 0
