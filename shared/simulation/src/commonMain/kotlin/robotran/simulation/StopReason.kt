package robotran.simulation

/** Why a session that was running until a stop has stopped. */
sealed interface StopReason {
    /**
     * The program is about to execute a line with a breakpoint.
     *
     * @property line from 1.
     * @property sourceFile the file of the line; null if the program has only one.
     * @property robot the index of the robot whose program it is.
     */
    data class Breakpoint(val line: Int, val sourceFile: String? = null, val robot: Int = 0) : StopReason

    /** The step has ended: the program is about to execute its next statement. */
    data object StepDone : StopReason

    /** The time limit is reached. */
    data object TimeUp : StopReason

    /** The program has ended, or no debuggable program was running. */
    data object Ended : StopReason
}
