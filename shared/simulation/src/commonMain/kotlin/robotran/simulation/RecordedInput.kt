package robotran.simulation

/**
 * An input and when it came.
 *
 * @property milliseconds the session's time then; the input takes effect in the tick that follows.
 */
data class RecordedInput(val milliseconds: Long, val input: SessionInput)
