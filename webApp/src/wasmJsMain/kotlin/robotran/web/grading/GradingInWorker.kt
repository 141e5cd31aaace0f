@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.grading

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.launch
import robotran.assignments.grading.workers.GradingOrder
import robotran.assignments.grading.workers.GradingWorker
import robotran.simulation.physics.loadPhysicsEngine

/** Whether the app runs in a worker, which has no page. */
internal fun isWorker(): Boolean = js("typeof document === 'undefined'")

/**
 * Answers the messages of the page; `WebGradingWorkers` is the other side. The first is a [GradingOrder], all others
 * are hand-ins.
 *
 * @param scope runs the work.
 */
internal fun gradeForPage(scope: CoroutineScope) {
    var worker: GradingWorker? = null
    onMessage { text ->
        scope.launch {
            try {
                val known = worker
                if (known == null) {
                    worker = GradingWorker(GradingOrder.parse(text), loadPhysicsEngine())
                    tell(READY, "")
                } else {
                    tell(GRADED, known.grade(text) { runs -> tell(RUNS, runs.toString()) })
                }
            } catch (problem: Throwable) {
                tell(FAILED, problem.message ?: problem.toString())
            }
        }
    }
    tell(STARTED, "")
}

private fun onMessage(take: (String) -> Unit): Unit = js("{ globalThis.onmessage = ({ data }) => take(data); }")

private fun tell(kind: String, text: String): Unit = js("globalThis.postMessage({ kind, text })")

/** The app runs and waits for its order. */
internal const val STARTED = "started"

/** It has its order and waits for hand-ins. */
internal const val READY = "ready"

/** With the number of runs that are over. */
internal const val RUNS = "runs"

/** With what [GradingWorker.grade] returned. */
internal const val GRADED = "graded"

/** With the reason. */
internal const val FAILED = "failed"
