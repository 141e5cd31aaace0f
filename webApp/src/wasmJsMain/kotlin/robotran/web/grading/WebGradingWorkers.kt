@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.grading

import kotlinx.coroutines.channels.ClosedReceiveChannelException
import kotlinx.coroutines.withTimeoutOrNull
import robotran.assignments.collecting.Submission
import robotran.assignments.grading.GradedHandIn
import robotran.assignments.grading.GradingPlan
import robotran.assignments.grading.workers.GradingOrder
import robotran.assignments.grading.workers.readGraded
import robotran.assignments.grading.workers.writeHandIn
import robotran.assignments.messages.GradingMessages
import robotran.language.Language
import robotran.projects.Project
import robotran.simulation.RobotProgramSet
import robotran.simulation.Session
import robotran.simulation.physics.loadPhysicsEngine
import robotran.simulation.state.SessionState
import robotran.workshop.platform.GradingCrew
import robotran.workshop.platform.GradingWorkers

/** Grades in workers of the browser, which run this app without a page. */
internal object WebGradingWorkers : GradingWorkers {
    override suspend fun start(assignment: Project, plan: GradingPlan, language: Language): GradingCrew? {
        val order = GradingOrder.of(assignment, plan, language)?.write() ?: return null
        val session = Session(plan.worlds.first().world, emptyList<RobotProgramSet>(), loadPhysicsEngine(), language)
        val start = session.state
        session.close()
        val crew = WorkerCrew(processors().coerceIn(1, MAX_WORKERS), order, plan, language, start)
        return crew.takeIf { it.canStart() }
    }

    /** Each needs some 50 MB. */
    private const val MAX_WORKERS = 8
}

/** @param start the state in which sessions in the plan's first world begin. */
private class WorkerCrew(
    override val size: Int,
    private val order: String,
    private val plan: GradingPlan,
    private val language: Language,
    private val start: SessionState,
) : GradingCrew {
    private val idle = ArrayDeque<PageWorker>()
    private val open = mutableSetOf<PageWorker>()

    /** Starts a first worker. */
    suspend fun canStart(): Boolean = try {
        idle += started()
        true
    } catch (_: WorkerFailure) {
        close()
        false
    }

    override suspend fun grade(submission: Submission.Usable, onProgress: (runs: Int) -> Unit): GradedHandIn {
        var worker: PageWorker? = null
        return try {
            val ready = idle.removeFirstOrNull() ?: started()
            worker = ready
            ready.send(writeHandIn(submission))
            var message = ready.next()
            while (message.kind == RUNS) {
                onProgress(message.text.toInt())
                message = ready.next()
            }
            if (message.kind != GRADED) throw WorkerFailure(message.text)
            val graded = readGraded(message.text, submission, plan, start)
            idle += ready
            worker = null
            graded
        } catch (failure: WorkerFailure) {
            failed(submission, failure)
        } catch (failure: IllegalArgumentException) {
            failed(submission, failure)
        } finally {
            // It may be in any state.
            worker?.let(::end)
        }
    }

    override fun close() {
        open.toList().forEach(::end)
        idle.clear()
    }

    private fun failed(submission: Submission.Usable, failure: Throwable) = GradedHandIn.Failed(
        submission,
        listOf(GradingMessages.of(language).couldNotBeGraded(failure.message.orEmpty())),
    )

    /** A new worker that is ready. What it needs may not have come the first time, for which no hand-in is to blame. */
    private suspend fun started(): PageWorker = try {
        ready()
    } catch (_: WorkerFailure) {
        ready()
    }

    private suspend fun ready(): PageWorker {
        val worker = try {
            PageWorker()
        } catch (problem: Throwable) {
            // The browser has no workers, or does not allow them.
            throw WorkerFailure(problem.message.orEmpty())
        }
        open += worker
        try {
            worker.expect(STARTED)
            worker.send(order)
            worker.expect(READY)
            return worker
        } catch (problem: Throwable) {
            end(worker)
            throw problem
        }
    }

    private fun end(worker: PageWorker) {
        worker.close()
        open -= worker
    }
}

/** A worker has ended or stands still. */
private class WorkerFailure(message: String) : Exception(message)

private suspend fun PageWorker.expect(kind: String) {
    val message = next()
    if (message.kind != kind) throw WorkerFailure(message.text)
}

/**
 * The next message.
 *
 * @throws WorkerFailure if none comes for too long. A machine that sleeps meanwhile does not count: each wait is short.
 */
private suspend fun PageWorker.next(): WorkerMessage {
    repeat(WAITS) {
        try {
            withTimeoutOrNull(WAIT_MILLISECONDS) { messages.receive() }?.let { return it }
        } catch (_: ClosedReceiveChannelException) {
            throw WorkerFailure("closed")
        }
    }
    throw WorkerFailure("timeout")
}

private fun processors(): Int = js("navigator.hardwareConcurrency || 2")

private const val WAIT_MILLISECONDS = 5_000L

/** Two minutes: the first Java program may have to wait for the compiler. Then there is a message several times a second. */
private const val WAITS = 24
