package robotran.rcxrom.clock

/** The clock of a brick. Not a function type, which would make an object of each number. */
internal fun interface Clock {
    /** Virtual time since the brick was first switched on. */
    fun milliseconds(): Long
}
