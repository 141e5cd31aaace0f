package robotran.assignments.grading

import robotran.assignments.collecting.Submission

/**
 * Grades [submissions] one after the other, in slices, so that a screen stays alive and shows [state] meanwhile.
 * [gradeAll] does the same at once.
 */
class GradingSession(private val grader: HandInGrader, submissions: List<Submission>) {
    private val board = GradingBoard(submissions, grader.plan.runs)
    private var current: RunningHandIn? = null

    /** What is known so far. */
    val state: GradingState get() = board.state

    /**
     * Compiles the next hand-in, or lets the current run go on for at most [milliseconds] of virtual time. A second of
     * it takes about 10 ms in a browser. Does nothing once [GradingState.isOver].
     */
    suspend fun step(milliseconds: Int) {
        val running = current
        if (running == null) begin() else goOn(running, milliseconds)
    }

    /** Ends grading: rows that have no result yet keep waiting. */
    fun cancel() {
        board.cancel()
        current?.close()
        current = null
    }

    private suspend fun begin() {
        val (row, submission) = board.begin() ?: return
        when (val preparation = grader.prepare(submission)) {
            // It may have been cancelled while it was compiled.
            is Preparation.Ready -> if (!board.isCancelled) current = RunningHandIn(row, preparation)

            is Preparation.HasErrors -> {
                board.finish(row, GradedHandIn.HasErrors(preparation.submission, preparation.reasons))
            }

            is Preparation.Failed -> board.finish(row, GradedHandIn.Failed(preparation.submission, preparation.reasons))
        }
    }

    private fun goOn(running: RunningHandIn, milliseconds: Int) {
        if (!running.advance(milliseconds)) return
        board.advance(running.row, running.results.size)
        val graded = running.graded() ?: return
        current = null
        board.finish(running.row, graded)
    }
}

/** The runs of the hand-in in a row. */
private class RunningHandIn(val row: Int, val preparation: Preparation.Ready) {
    private val runs = preparation.runs()
    val results = mutableListOf<RunResult>()

    /** Whether the current run is over now. */
    fun advance(milliseconds: Int): Boolean {
        val result = runs[results.size].advance(milliseconds) ?: return false
        results += result
        return true
    }

    /** Null until all runs are over. */
    fun graded(): GradedHandIn? = if (results.size == runs.size) preparation.graded(results) else null

    fun close() = runs.forEach(PreparedRun::close)
}

/**
 * The progress of grading.
 *
 * @property rows one for each submission, in their order.
 * @property runsDone of [runsInTotal], without those of hand-ins that cannot run.
 */
data class GradingState(
    val rows: List<GradingRow>,
    val runsDone: Int,
    val runsInTotal: Int,
    val isCancelled: Boolean = false,
) {
    val isOver: Boolean get() = isCancelled || rows.all { it is GradingRow.Graded }

    /** Those that are graded. */
    val results: List<GradedHandIn> get() = rows.mapNotNull { (it as? GradingRow.Graded)?.result }

    /**
     * How long the rest will take, in milliseconds; null as long as nothing can be said.
     *
     * @param elapsed milliseconds of real time since grading began.
     */
    fun millisecondsLeft(elapsed: Long): Long? =
        if (runsDone == 0) null else elapsed * (runsInTotal - runsDone) / runsDone
}

/** The progress of one submission. */
sealed interface GradingRow {
    val submission: Submission

    data class Waiting(override val submission: Submission) : GradingRow

    /** @property done number of runs that are over, of [total]. */
    data class Running(override val submission: Submission.Usable, val done: Int, val total: Int) : GradingRow

    data class Graded(val result: GradedHandIn) : GradingRow {
        override val submission: Submission get() = result.submission
    }
}

/**
 * Grades [submissions] at once. The result is the same as that of a [GradingSession].
 *
 * @param finish finishes all given runs, at the same time if it likes, and returns their results in the same order.
 */
suspend fun gradeAll(
    grader: HandInGrader,
    submissions: List<Submission>,
    finish: (List<PreparedRun>) -> List<RunResult>,
): List<GradedHandIn> {
    val prepared = submissions.map { if (it is Submission.Usable) grader.prepare(it) else null }
    val runs = prepared.filterIsInstance<Preparation.Ready>().associateWith { it.runs() }
    val results = finish(runs.values.flatten()).iterator()
    return submissions.zip(prepared) { submission, preparation ->
        when (preparation) {
            null -> GradedHandIn.Unusable(submission as Submission.Unusable)
            is Preparation.Ready -> preparation.graded(runs.getValue(preparation).map { results.next() })
            is Preparation.HasErrors -> GradedHandIn.HasErrors(preparation.submission, preparation.reasons)
            is Preparation.Failed -> GradedHandIn.Failed(preparation.submission, preparation.reasons)
        }
    }
}
