package robotran.rcxrom.program

/** A program that can be loaded into a slot of the brick, whatever language it was written in. */
interface RcxProgram {
    /** The name a pupil knows it by, usually that of its file. */
    val name: String

    /** Begins a new run from the first statement. The run acts on the robot only through [rom]. */
    fun start(rom: Rom): ProgramRun
}

/**
 * One run of an [RcxProgram]: it advances only when it is told to, so it can be paused, stepped and stopped at any
 * time.
 */
interface ProgramRun {
    /** The line about to be executed, or the last one once the run is over; from 1, 0 if there is none. */
    val sourceLine: Int

    /** The file that [sourceLine] is in; null if the program has only one. */
    val sourceFile: String? get() = null

    /** What a pupil should know about this run so far, though it goes on. */
    val remarks: List<RuntimeWarning> get() = emptyList()

    /**
     * Executes at most [steps] steps (a step is a statement or a bytecode) and returns early when the program waits,
     * ends or fails. Must not be called again after [ProgramStatus.Ended] or [ProgramStatus.Failed].
     */
    fun resume(steps: Int): ProgramStatus
}

/** How a [ProgramRun] stands after a [ProgramRun.resume]. */
sealed interface ProgramStatus {
    /** The budget is used up; there is more to do. */
    data object Running : ProgramStatus

    /** Stopped before a statement because a [StatementWatch] said so, with [stepsLeft] of the budget not used yet. */
    data class Paused(val stepsLeft: Int) : ProgramStatus

    /** Nothing to do until the brick's clock, [Rom.milliseconds], has reached [untilMilliseconds]. */
    data class Waiting(val untilMilliseconds: Long) : ProgramStatus

    /**
     * One of the program's threads cannot go on; the others can. A brick shows the failure and waits for On-Off first;
     * its motors go on meanwhile.
     */
    data class ThreadFailed(val failure: ProgramFailure) : ProgramStatus

    /** The program came to its end. */
    data object Ended : ProgramStatus

    /** The program cannot go on. */
    data class Failed(val failure: ProgramFailure) : ProgramStatus
}

/**
 * Why a program could not go on.
 *
 * @property message one sentence in a learner's words.
 * @property sourceLine the line it happened on, from 1; 0 if there is none.
 * @property methodNumber what the display shows as its number: in leJOS that of the method's signature, else the line.
 * 0 or more.
 * @property exceptionNumber what the program digit shows, by its last figure: in leJOS that of the exception's class. 0
 * or more.
 * @property sourceFile the file it happened in; null if the program has only one.
 */
data class ProgramFailure(
    val message: String,
    val sourceLine: Int,
    val methodNumber: Int = sourceLine,
    val exceptionNumber: Int = 0,
    val sourceFile: String? = null,
)

/**
 * Something a pupil should know about a run, though it goes on.
 *
 * @property message a sentence or two in a pupil's words.
 * @property sourceLine the line it happened on, from 1; 0 if there is none.
 * @property sourceFile the file it happened in; null if the program has only one.
 */
data class RuntimeWarning(val message: String, val sourceLine: Int, val sourceFile: String? = null)
