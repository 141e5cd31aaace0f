package robotran.brick.program

import robotran.brick.kind.BrickKind

/**
 * A program that can be loaded onto a brick, in any language. A brick of another [kind] does not start it.
 *
 * @property name the name that the pupil sees, usually the file's.
 */
interface BrickProgram {
    val name: String
    val kind: BrickKind

    companion object {
        /** Max number of programs on a brick: an RCX of LEGO shows as many program numbers. */
        const val MAX_PROGRAMS = 5
    }
}

/** One run of a [BrickProgram]. It advances only in [resume], so it can be paused, stepped and stopped at any time. */
interface ProgramRun {
    /** The line to be executed next, or the last one once the run is over; from 1, 0 if there is none. */
    val sourceLine: Int

    /** The file of [sourceLine]; null if the program has only one. */
    val sourceFile: String? get() = null

    /** Warnings for the pupil about this run so far. */
    val warnings: List<RuntimeWarning> get() = emptyList()

    /**
     * Executes at most [steps] steps (a step is a statement or a bytecode) and returns early when the program waits,
     * ends or fails. Must not be called again after [ProgramStatus.Ended] or [ProgramStatus.Failed].
     */
    fun resume(steps: Int): ProgramStatus
}

/** The state of a [ProgramRun] after a [ProgramRun.resume]. */
sealed interface ProgramStatus {
    /** The step budget is used up; there is more to do. */
    data object Running : ProgramStatus

    /** A [StatementWatch] paused the run before a statement, with [stepsLeft] of the step budget unused. */
    data class Paused(val stepsLeft: Int) : ProgramStatus

    /** Nothing to do until the brick's clock reaches [untilMilliseconds]. */
    data class Waiting(val untilMilliseconds: Long) : ProgramStatus

    /**
     * One of the program's threads failed; the others can continue. A brick first shows the failure and waits for
     * On-Off; its motors keep running meanwhile.
     */
    data class ThreadFailed(val failure: ProgramFailure) : ProgramStatus

    data object Ended : ProgramStatus

    data class Failed(val failure: ProgramFailure) : ProgramStatus
}

/**
 * Why a program failed.
 *
 * @property message one sentence in words a pupil knows.
 * @property sourceLine the line of the failure, from 1; 0 if there is none.
 * @property methodNumber the number on the display: in leJOS that of the method's signature, otherwise the line. 0 or
 * more.
 * @property exceptionNumber its last digit is the program digit: in leJOS the number of the exception's class. 0 or
 * more.
 * @property sourceFile the file of the failure; null if the program has only one.
 * @property stack the calls that were active, innermost first, as an NXT shows them; empty if the language has none.
 * @property thrownText the text that the program gave the exception, as an NXT shows it; null if none.
 * @property causes the exceptions that caused it, as an NXT shows them, the nearest first.
 */
data class ProgramFailure(
    val message: String,
    val sourceLine: Int,
    val methodNumber: Int = sourceLine,
    val exceptionNumber: Int = 0,
    val sourceFile: String? = null,
    val stack: List<FailureFrame> = emptyList(),
    val thrownText: String? = null,
    val causes: List<FailureCause> = emptyList(),
)

/**
 * An exception that caused another.
 *
 * @property exceptionNumber the number of its class.
 * @property thrownText the text that the program gave it; null if none.
 * @property calls the calls that were active when it was made, innermost first.
 */
data class FailureCause(val exceptionNumber: Int, val thrownText: String?, val calls: List<FailureCall>)

/** A call as an NXT shows it: the number of the method, and the [offset] in its code, in bytes. */
data class FailureCall(val methodNumber: Int, val offset: Int)

/**
 * A call that was active when a program failed.
 *
 * @property methodNumber the number that an NXT shows for the method.
 * @property offset of the instruction in the method's code, in bytes.
 * @property name of the method, for people.
 * @property sourceLine its line, from 1; 0 if there is none.
 * @property sourceFile the file of the line; null if the program has only one.
 */
data class FailureFrame(
    val methodNumber: Int,
    val offset: Int,
    val name: String,
    val sourceLine: Int = 0,
    val sourceFile: String? = null,
)

/**
 * A warning for the pupil about a run that continues.
 *
 * @property message a sentence or two in words a pupil knows.
 * @property sourceLine the line of its cause, from 1; 0 if there is none.
 * @property sourceFile the file of its cause; null if the program has only one.
 */
data class RuntimeWarning(val message: String, val sourceLine: Int, val sourceFile: String? = null)
