package robotran.simulation

/**
 * An input and its time.
 *
 * @property milliseconds the session's time; the input takes effect in the next tick.
 */
data class RecordedInput(val milliseconds: Long, val input: SessionInput)
