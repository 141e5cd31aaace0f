package robotran.workshop.handins

import kotlinx.coroutines.delay
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingRow
import robotran.assignments.grading.GradingSession
import robotran.assignments.grading.GradingState
import robotran.assignments.grading.HandInGrader
import robotran.workshop.platform.Platform
import kotlin.coroutines.EmptyCoroutineContext

/** Grades hand-ins in slices, so that the screen stays alive. */
internal class GradingLoop(private val platform: Platform, private val grader: HandInGrader) {
    /** Where there is a thread for it, a slice need not be short. */
    private val budget = if (platform.background == EmptyCoroutineContext) FRAME_MILLISECONDS else THREAD_MILLISECONDS

    /**
     * Grades [submissions], which have IDs. Cancelling the coroutine ends it.
     *
     * @param onGraded is called with each result.
     * @param onProgress is called now and then, with the milliseconds that are left if anything can be said.
     */
    suspend fun grade(
        submissions: Map<String, Submission>,
        onGraded: (String, GradedHandIn) -> Unit,
        onProgress: (GradingState, millisecondsLeft: Long?) -> Unit,
    ) {
        val ids = submissions.keys.toList()
        val session = GradingSession(grader, submissions.values.toList())
        val began = platform.clock.now
        var told = 0
        var toldAt = began
        try {
            while (!session.state.isOver) {
                withContext(platform.background) { slice(session) }
                val state = session.state
                val graded = state.rows.count { it is GradingRow.Graded }
                val now = platform.clock.now
                if (graded > told) {
                    // Rows are graded in their order.
                    for (index in told..<graded) onGraded(ids[index], (state.rows[index] as GradingRow.Graded).result)
                    told = graded
                }
                if (now - toldAt >= PROGRESS_MILLISECONDS || graded == state.rows.size) {
                    toldAt = now
                    val elapsed = now - began
                    onProgress(state, if (elapsed < SURE_MILLISECONDS) null else state.millisecondsLeft(elapsed))
                }
                delay(1)
            }
        } finally {
            session.cancel()
        }
    }

    private suspend fun slice(session: GradingSession) {
        val start = platform.clock.now
        var steps = 0
        do {
            session.step(STEP_MILLISECONDS)
        } while (++steps < MAX_STEPS && platform.clock.now - start < budget && !session.state.isOver)
    }

    private companion object {
        /** Real time: half a frame. */
        const val FRAME_MILLISECONDS = 8L
        const val THREAD_MILLISECONDS = 100L

        /** Virtual time of a step, about a millisecond of real time in a browser. */
        const val STEP_MILLISECONDS = 100

        /** Also ends a slice if the clock stands still. */
        const val MAX_STEPS = 2_000

        /** Real time between two reports. */
        const val PROGRESS_MILLISECONDS = 200L

        /** Real time before which nobody can tell how long it will take. */
        const val SURE_MILLISECONDS = 1_500L
    }
}
