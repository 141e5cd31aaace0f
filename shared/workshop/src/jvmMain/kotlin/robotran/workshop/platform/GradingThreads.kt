package robotran.workshop.platform

import kotlinx.coroutines.asCoroutineDispatcher
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.channels.consumeEach
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.ensureActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import kotlinx.coroutines.withContext
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.HandInGrader
import robotran.assignments.grading.finish
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.physics.loadPhysicsEngine
import java.util.concurrent.Executors
import kotlin.coroutines.coroutineContext

/**
 * Grades with a thread for each processor.
 *
 * @param size how many hand-ins are graded at the same time.
 */
class GradingThreads(private val size: Int = Runtime.getRuntime().availableProcessors()) : GradingWorkers {
    override suspend fun start(assignment: Project, plan: GradingPlan, language: Language): GradingCrew =
        ThreadCrew(size, HandInGrader(assignment, plan, loadPhysicsEngine(), language))
}

private class ThreadCrew(override val size: Int, private val grader: HandInGrader) : GradingCrew {
    private val threads = Executors.newFixedThreadPool(size) { work ->
        // The screen comes first.
        Thread(work, "grading").apply {
            isDaemon = true
            priority = Thread.MIN_PRIORITY
        }
    }
    private val dispatcher = threads.asCoroutineDispatcher()
    private val compiling = Mutex()

    override suspend fun grade(submission: Submission.Usable, onProgress: (runs: Int) -> Unit): GradedHandIn =
        coroutineScope {
            val progress = Channel<Int>(Channel.CONFLATED)
            launch { progress.consumeEach(onProgress) }
            val graded = withContext(dispatcher) {
                val preparation = compiling.withLock { grader.prepare(submission) }
                val context = coroutineContext
                preparation.finish { runs ->
                    context.ensureActive()
                    progress.trySend(runs)
                }
            }
            progress.close()
            graded
        }

    override fun close() = threads.shutdown()
}
