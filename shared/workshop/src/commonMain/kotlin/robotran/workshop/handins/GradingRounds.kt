package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingRow
import robotran.assignments.grading.GradingState
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.platform.Platform
import robotran.workshop.state.GradingProgress
import robotran.workshop.state.HandInsState

/**
 * Grades what waits on the page, in rounds: what is brought in during one is graded in the next, so that nothing has to
 * begin anew.
 *
 * @param show changes the page, see [HandInsState].
 */
internal class GradingRounds(
    private val platform: Platform,
    private val scope: CoroutineScope,
    private val physics: PhysicsEngine,
    private val state: () -> HandInsState?,
    private val show: (HandInsState.() -> HandInsState) -> Unit,
) {
    private var job: Job? = null

    /** Grades all that waits on the page for [open], also what comes while it does. */
    fun begin(open: OpenAssignment) {
        show { copy(isStopped = false) }
        if (waiting().isEmpty()) return stop()
        if (job?.isActive == true) return showCounts()
        show { copy(progress = progressOf(null, null)) }
        job = scope.launch {
            // A hand-in with a wrong program must not hold up what is drawn first.
            delay(1)
            val loop = GradingLoop(platform, open.project, open.plan, physics, open.language)
            do {
                val round = waiting()
                if (round.isNotEmpty()) grade(round, loop)
            } while (round.isNotEmpty())
            show { copy(progress = null).sorted() }
        }
    }

    private suspend fun grade(round: Map<String, Submission>, loop: GradingLoop) {
        val onGraded = { id: String, result: GradedHandIn -> showResult(id, round.getValue(id), result) }
        loop.grade(round, onGraded) { grading, left -> show { copy(progress = progressOf(grading, left)) } }
    }

    /** What is graded stays. */
    fun stop() {
        job?.cancel()
        show { copy(progress = null) }
    }

    /** Until the next report of the round. */
    private fun showCounts() = show {
        copy(progress = progress?.copy(handIns = rows.count { it.graded != null }, of = rows.size))
    }

    private fun waiting(): Map<String, Submission> = state()?.rows.orEmpty()
        .filter { it.graded == null && it.submission is Submission.Usable }.associate { it.id to it.submission }

    private fun showResult(id: String, of: Submission, result: GradedHandIn) = show {
        // It may have been replaced by a later one, or removed.
        val rows = rows.map { if (it.id == id && it.submission == of) it.copy(graded = result) else it }
        // The rows keep their places until all are graded, so that none moves away from under a finger.
        copy(rows = rows, progress = progress?.copy(handIns = rows.count { it.graded != null }))
    }
}

/** @param left milliseconds for what [grading] knows. */
private fun HandInsState.progressOf(grading: GradingState?, left: Long?): GradingProgress {
    val done = rows.count { it.graded != null }
    val begun = grading?.rows.orEmpty().filterIsInstance<GradingRow.Running>().sumOf { it.done.toDouble() / it.total }
    val inRound = grading?.rows.orEmpty().count { it !is GradingRow.Graded }
    // What came meanwhile takes about as long as the others.
    val all = if (left == null || inRound == 0) left else left * maxOf(inRound, rows.size - done) / inRound
    val seconds = all?.let { ((it + MILLISECONDS / 2) / MILLISECONDS).toInt() }
    return GradingProgress(done, rows.size, ((done + begun) / rows.size).toFloat().coerceAtMost(1f), seconds)
}

private const val MILLISECONDS = 1_000L
