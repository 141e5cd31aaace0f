package robotran.workshop.handins

import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingRow
import robotran.assignments.grading.GradingState
import robotran.workshop.platform.WallClock

/**
 * Passes on each result once, in whatever order they come, and now and then the progress.
 *
 * @param ids of the rows.
 */
internal class GradingUpdates(
    private val ids: List<String>,
    private val clock: WallClock,
    private val onGraded: (String, GradedHandIn) -> Unit,
    private val onProgress: (GradingState, millisecondsLeft: Long?) -> Unit,
) {
    private val began = clock.now
    private var reportedAt = began
    private val reported = mutableSetOf<Int>()

    fun tell(state: GradingState) {
        state.rows.forEachIndexed { index, row ->
            if (row is GradingRow.Graded && reported.add(index)) onGraded(ids[index], row.result)
        }
        val now = clock.now
        if (now - reportedAt < PROGRESS_MILLISECONDS && reported.size < ids.size) return
        reportedAt = now
        val elapsed = now - began
        onProgress(state, if (elapsed < SURE_MILLISECONDS) null else state.millisecondsLeft(elapsed))
    }

    private companion object {
        /** Real time between two reports. */
        const val PROGRESS_MILLISECONDS = 200L

        /** Real time before which nobody can tell how long it will take. */
        const val SURE_MILLISECONDS = 1_500L
    }
}
