package robotran.simulation

/** Why a session that was told to run until something stops it has stopped. */
sealed interface StopReason {
    /**
     * The program is about to do a statement of a line with a breakpoint.
     *
     * @property line from 1.
     * @property sourceFile the file that the line is in; null if the program has only one.
     */
    data class Breakpoint(val line: Int, val sourceFile: String? = null) : StopReason

    /** The step is done: the program is about to do its next statement. */
    data object StepDone : StopReason

    /** The time is up. */
    data object TimeUp : StopReason

    /** The program is over, or none was running that can be stepped through. */
    data object Ended : StopReason
}
