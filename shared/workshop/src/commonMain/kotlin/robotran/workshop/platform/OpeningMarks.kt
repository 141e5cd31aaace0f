package robotran.workshop.platform

/**
 * Marks of what is being opened. They are written at once and outlive the app, however it ends: what is still marked at
 * the next start was not opened to its end.
 *
 * Names have the form of names in a [KeyValueStore].
 */
interface OpeningMarks {
    /** Marks [name] at [time], in milliseconds since 1970. */
    fun put(name: String, time: Long)

    /** Removes the mark of [name], if there is one. */
    fun remove(name: String)

    /** When [name] was marked; null if it is not. */
    fun timeOf(name: String): Long?
}

/** A platform without marks. */
object NoOpeningMarks : OpeningMarks {
    override fun put(name: String, time: Long) = Unit

    override fun remove(name: String) = Unit

    override fun timeOf(name: String): Long? = null
}
