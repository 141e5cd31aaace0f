package robotran.assignments.grading

import robotran.assignments.collecting.Submission

/**
 * Keeps the progress of grading [submissions], in whatever order their results come. Not thread-safe.
 *
 * @param runsOfOne the number of runs of a hand-in of which only one thing can count.
 */
class GradingBoard(private val submissions: List<Submission>, private val runsOfOne: Int) {
    private val rows: MutableList<GradingRow> = submissions.mapTo(mutableListOf()) {
        if (it is Submission.Unusable) GradingRow.Graded(GradedHandIn.Unusable(it)) else GradingRow.Waiting(it)
    }

    var isCancelled = false
        private set

    /** What is known so far. */
    val state: GradingState
        get() = GradingState(rows.toList(), rows.indices.sumOf(::done), rows.indices.sumOf(::total), isCancelled)

    /** Begins with the first row that waits: returns its index and hand-in, or null if none waits. */
    fun begin(): Pair<Int, Submission.Usable>? {
        val row = if (isCancelled) -1 else rows.indexOfFirst { it is GradingRow.Waiting }
        val submission = submissions.getOrNull(row) as? Submission.Usable ?: return null
        rows[row] = GradingRow.Running(submission, 0, runsOf(row))
        return row to submission
    }

    /** Notes that [runs] of the hand-in in [row] are over. Late news of a row that is graded, or waits again, is ignored. */
    fun advance(row: Int, runs: Int) {
        val running = rows[row] as? GradingRow.Running ?: return
        rows[row] = running.copy(done = runs)
    }

    /** Notes the result of the hand-in in [row]. */
    fun finish(row: Int, result: GradedHandIn) {
        if (!isCancelled) rows[row] = GradingRow.Graded(result)
    }

    /** Ends grading: rows that have no result yet keep waiting. */
    fun cancel() {
        isCancelled = true
        rows.forEachIndexed { row, state ->
            if (state is GradingRow.Running) {
                rows[row] =
                    GradingRow.Waiting(state.submission)
            }
        }
    }

    private fun total(row: Int): Int = when (val state = rows[row]) {
        is GradingRow.Waiting -> runsOf(row)
        is GradingRow.Running -> state.total
        is GradingRow.Graded -> if (state.result is GradedHandIn.Graded) runsOf(row) else 0
    }

    private fun done(row: Int): Int = when (val state = rows[row]) {
        is GradingRow.Waiting -> 0
        is GradingRow.Running -> state.done
        is GradingRow.Graded -> total(row)
    }

    /** As many as there may be: what has mistakes does not run. */
    private fun runsOf(row: Int): Int = runsOfOne * ((submissions[row] as? Submission.Usable)?.attempts?.size ?: 0)
}
