package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingRow
import robotran.assignments.grading.GradingState
import robotran.assignments.reporting.linesOfCode
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.platform.Platform
import robotran.workshop.state.GradingProgress
import robotran.workshop.state.HandInRow
import robotran.workshop.state.HandInsState

/**
 * Grades what waits on the page, in rounds: what is brought in during one is graded in the next, so that nothing has to
 * begin anew.
 *
 * @param show changes the page, see [HandInsState].
 */
internal class GradingRuns(
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
            do {
                val round = waiting()
                for ((task, ofTask) in round.groupBy { it.task }) {
                    val graded = open.tasks[task]
                    val loop = GradingLoop(platform, graded.project, graded.plan, physics, open.language)
                    val results = KeptResults(open.kept, graded, open.language, physics)
                    grade(open, ofTask.associate { it.id to it.collected }, loop, results)
                }
            } while (round.isNotEmpty())
            show { copy(progress = null).sorted(open.language) }
        }
    }

    private suspend fun grade(
        open: OpenAssignment,
        round: Map<String, Submission>,
        loop: GradingLoop,
        results: KeptResults,
    ) {
        val usable = round.mapNotNull { (id, submission) ->
            (submission as? Submission.Usable)?.let { id to it }
        }.toMap()
        val known = usable.mapNotNull { (id, submission) -> results.textFor(submission)?.let { id to it } }.toMap()
        val probe = known.keys.firstOrNull()
        if (probe != null && !open.areResultsTrue) {
            val found = gradeNow(usable.filterKeys { it == probe }, loop)[probe] ?: return
            open.areResultsTrue = results.write(found, usable.getValue(probe)) == known.getValue(probe)
            if (!open.areResultsTrue) open.kept.forgetResults()
        }
        if (open.areResultsTrue) {
            for ((id, text) in known.filterKeys(::isWaiting)) {
                results.read(text, usable.getValue(id))?.let { showResult(id, usable.getValue(id), it) }
            }
        }
        gradeNow(usable.filterKeys(::isWaiting), loop) { submission, result ->
            scope.launch { results.keep(result, submission) }
        }
    }

    private fun isWaiting(id: String): Boolean = state()?.rows.orEmpty().any { it.id == id && it.graded == null }

    private suspend fun gradeNow(
        some: Map<String, Submission.Usable>,
        loop: GradingLoop,
        onGraded: (Submission.Usable, GradedHandIn) -> Unit = { _, _ -> },
    ): Map<String, GradedHandIn> {
        val found = linkedMapOf<String, GradedHandIn>()
        if (some.isEmpty()) return found
        loop.grade(
            some,
            { id, result ->
                found[id] = result
                showResult(id, some.getValue(id), result)
                onGraded(some.getValue(id), result)
            },
            { grading, left -> show { copy(progress = progressOf(grading, left)) } },
        )
        return found
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

    private fun waiting(): List<HandInRow> =
        state()?.rows.orEmpty().filter { it.graded == null && it.collected is Submission.Usable }

    private fun showResult(id: String, of: Submission, result: GradedHandIn) = show {
        // It may have been replaced by a later one, or removed.
        val rows = rows.map { if (it.id == id && it.collected == of) graded(it, result) else it }
        // The rows keep their places until all are graded, so that none moves away from under a finger.
        copy(rows = rows, progress = progress?.copy(handIns = rows.count { it.graded != null }))
    }
}

private fun graded(row: HandInRow, result: GradedHandIn) =
    row.copy(graded = result, lines = result.submission.linesOfCode)

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
