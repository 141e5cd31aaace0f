package robotran.nxt.hardware

/** The clock of a brick. Not a function type, which would make an object of each number. */
fun interface Clock {
    /** Virtual time since the brick was first switched on. */
    fun milliseconds(): Long
}
