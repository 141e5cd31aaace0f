package robotran.rcxrom.infrared

/** How far the infrared light of a brick is to reach. */
enum class InfraredRange {
    /** Across a table. */
    SHORT,

    /** Through a room. */
    LONG,
}

/** Decides which bricks see each other's light; must answer the same whenever asked the same in one millisecond. */
fun interface InfraredReach {
    /**
     * Whether the light of [sender] comes to [receiver]; both are numbers in the order in which they came into the air,
     * from 0.
     */
    fun reaches(sender: Int, receiver: Int, range: InfraredRange): Boolean

    companion object {
        /** Everybody sees everybody, as on one table. */
        val EVERYWHERE = InfraredReach { _, _, _ -> true }
    }
}
