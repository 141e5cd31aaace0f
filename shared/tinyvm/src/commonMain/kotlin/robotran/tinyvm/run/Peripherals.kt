package robotran.tinyvm.run

/** What the machine has around it: a brick's clock and whatever else native methods use. */
internal interface Peripherals {
    /** The brick's clock. */
    val milliseconds: Long

    /** Called once, before anything else. */
    fun attach(machine: VirtualMachine)

    /** Looks for what has happened outside of the machine; called each time before it continues. */
    fun poll()

    /** When [poll] should be called next although all threads wait; null if it need not be. */
    val wakesAt: Long?

    /** Passes the objects to [mark] that are needed although no object or thread of the program refers to them. */
    fun roots(mark: (Int) -> Unit)

    /** Forgets the objects for which [isGone] returns true. */
    fun forget(isGone: (Int) -> Boolean)

    /**
     * Called while no thread but daemons is alive, and when the program is to end: whether it goes on until it ends
     * itself.
     */
    fun delaysEnd(): Boolean
}
