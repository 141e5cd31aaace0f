package robotran.legofirmware.event

/** What events compare with what was before. */
internal interface EventReadings {
    fun value(source: EventSource): Int

    /** 1 or 0 for a sensor, otherwise 0. */
    fun boolean(source: EventSource): Int

    /** What the port of a sensor measures, otherwise 0. */
    fun raw(source: EventSource): Int

    /** Mode and slope of a sensor, otherwise 0. */
    fun mode(source: EventSource): Int
}
