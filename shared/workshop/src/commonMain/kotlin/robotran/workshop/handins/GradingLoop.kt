package robotran.workshop.handins

import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingBoard
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.GradingSession
import robotran.assignments.grading.GradingState
import robotran.assignments.grading.HandInGrader
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.physics.PhysicsEngine
import robotran.workshop.platform.GradingCrew
import robotran.workshop.platform.Platform
import kotlin.coroutines.EmptyCoroutineContext

/**
 * Grades hand-ins for [assignment] without holding up the screen: with the platform's workers, or else in slices.
 *
 * @param plan of [assignment].
 * @param language of goals and errors.
 */
internal class GradingLoop(
    private val platform: Platform,
    private val assignment: Project,
    private val plan: GradingPlan,
    private val physics: PhysicsEngine,
    private val language: Language,
) {
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
        val news = GradingUpdates(submissions.keys.toList(), platform.clock, onGraded, onProgress)
        val all = submissions.values.toList()
        val crew = platform.gradingWorkers?.start(assignment, plan, language)
        if (crew == null) gradeInSlices(all, news) else gradeWith(crew, all, news)
    }

    private suspend fun gradeWith(crew: GradingCrew, submissions: List<Submission>, news: GradingUpdates) {
        val board = GradingBoard(submissions, plan.runs)
        try {
            coroutineScope { repeat(crew.size) { launch { gradeNext(crew, board, news) } } }
            news.tell(board.state)
        } finally {
            crew.close()
        }
    }

    private suspend fun gradeNext(crew: GradingCrew, board: GradingBoard, news: GradingUpdates) {
        while (true) {
            val (row, submission) = board.begin() ?: return
            val result = crew.grade(submission) { runs ->
                board.advance(row, runs)
                news.tell(board.state)
            }
            board.finish(row, result)
            news.tell(board.state)
        }
    }

    private suspend fun gradeInSlices(submissions: List<Submission>, news: GradingUpdates) {
        val session = GradingSession(HandInGrader(assignment, plan, physics, language), submissions)
        try {
            while (!session.state.isOver) {
                withContext(platform.background) { slice(session) }
                news.tell(session.state)
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
    }
}
