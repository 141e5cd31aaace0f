package robotran.workshop.state

/** What the run bar says, the most important thing first. */
sealed interface WorkshopStatus {
    /** Nothing has run yet, and Run would work. */
    data object Ready : WorkshopStatus

    /** There is nothing to run. */
    data object Empty : WorkshopStatus

    /**
     * Nothing can run before [line], 0 if the mistake is at none, of [file] is mended; null if the program has only one
     * file.
     */
    data class HasErrors(val line: Int, val file: String? = null) : WorkshopStatus

    /** The text is not the program that ran last. */
    data object Changed : WorkshopStatus

    /** The Java program is being compiled, which takes longest the first time. */
    data object Compiling : WorkshopStatus

    /** The compiler for Java could not be fetched. */
    data object NoCompiler : WorkshopStatus

    /** The compiler failed on the program, by a mistake of its own. */
    data object CompilerFailed : WorkshopStatus

    /** The brick is switched off. */
    data object Off : WorkshopStatus

    /** The program is at [line]; 0 if it is at none. */
    data class Running(val line: Int) : WorkshopStatus

    /** Time stands still, and the program is before [line]; 0 if it is at none. */
    data class Paused(val line: Int) : WorkshopStatus

    /** The program came to its end, or somebody stopped it, and the world's [goals], if it has any, stand like this. */
    data class Ended(val stopped: Boolean, val goals: GoalCount = GoalCount()) : WorkshopStatus

    /** The program could not go on at [line], 0 if at none, of [file], null if it has only one; [message] says why. */
    data class Failed(val line: Int, val message: String, val file: String? = null) : WorkshopStatus
}
