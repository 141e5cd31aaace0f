package robotran.rcxrom.infrared

/** The range of a brick's infrared light. */
enum class InfraredRange {
    /** Across a table. */
    SHORT,

    /** Through a room. */
    LONG,
}

/** Decides which bricks see each other's light; must return equal answers within one millisecond. */
fun interface InfraredReach {
    /**
     * Whether light from [sender] reaches [receiver]; both are port numbers in the order in which the ports were
     * opened, from 0.
     */
    fun reaches(sender: Int, receiver: Int, range: InfraredRange): Boolean

    companion object {
        /** All see all others, as on one table. */
        val EVERYWHERE = InfraredReach { _, _, _ -> true }
    }
}
