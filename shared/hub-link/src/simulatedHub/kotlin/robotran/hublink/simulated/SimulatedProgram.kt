package robotran.hublink.simulated

/** What a program does on a simulated hub, which cannot run Python. */
fun interface SimulatedProgram {
    /** Runs until it returns, or is cancelled because somebody stops it. */
    suspend fun run(host: SimulatedHost)

    companion object {
        /** Prints [text] and ends. */
        fun printing(text: String) = SimulatedProgram { it.print(text) }
    }
}

/** What a running program has of its hub. */
interface SimulatedHost {
    /** Prints [text], whose lines end with CR LF on a hub. */
    fun print(text: String)

    /** The next byte of the input; waits for one. */
    suspend fun read(): Byte

    /** From now on a stop is caught by a bare `except:` which prints [text]. */
    fun catchEverything(text: String)
}
