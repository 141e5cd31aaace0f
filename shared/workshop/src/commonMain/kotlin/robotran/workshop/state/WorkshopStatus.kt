package robotran.workshop.state

import robotran.world.robot.DraftError

/** The status in the run bar, by priority. */
sealed interface WorkshopStatus {
    /** Nothing has run yet, and Run is possible. */
    data object Ready : WorkshopStatus

    /** There is no code to run. */
    data object Empty : WorkshopStatus

    /**
     * An error at [line], 0 if it has no position, in [file] prevents all runs. [file] is null if the program has only
     * one.
     */
    data class HasErrors(val line: Int, val file: String? = null) : WorkshopStatus

    /** No program runs, because a robot of the world cannot be built like this. */
    data class RobotImpossible(val draft: DraftError) : WorkshopStatus

    /** The program has changed since the last run. */
    data object Changed : WorkshopStatus

    /** The Java program is being compiled; the first time takes longest. */
    data object Compiling : WorkshopStatus

    /** The Java compiler could not be loaded. */
    data object NoCompiler : WorkshopStatus

    /** The compiler crashed on the program because of a bug. */
    data object CompilerFailed : WorkshopStatus

    /** The brick is switched off. */
    data object Off : WorkshopStatus

    /** The task is completed. Its program may not have ended. */
    data object Solved : WorkshopStatus

    /** The goals are reached in one place of a lesson, but not in the other one yet. Its program may not have ended. */
    data object SolvedHere : WorkshopStatus

    /** The task's time limit of [seconds] is reached, and not all goals are met. Its program may not have ended. */
    data class TimeUp(val seconds: Int) : WorkshopStatus

    /** The program runs, but a robot has left the paper. [robot] is its name; null in a world with only one. */
    data class OffPaper(val robot: String?) : WorkshopStatus

    /** The program is at [line]; 0 if unknown. */
    data class Running(val line: Int) : WorkshopStatus

    /** Time is paused and the program is before [line]; 0 if unknown. */
    data class Paused(val line: Int) : WorkshopStatus

    /** The program ended or was [stopped]. [goals] is the result of the world's goals, if any. */
    data class Ended(val stopped: Boolean, val goals: GoalCount = GoalCount()) : WorkshopStatus

    /** The program failed at [line], 0 if unknown, in [file], null if it has only one; [message] is the reason. */
    data class Failed(val line: Int, val message: String, val file: String? = null) : WorkshopStatus
}
