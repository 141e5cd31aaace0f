@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.grading

import kotlinx.coroutines.channels.Channel

/** What a worker says, or that it has ended. */
internal class WorkerMessage(val kind: String, val text: String)

/** A worker that runs the app, see [gradeForPage]. */
internal class PageWorker {
    private val worker = openWorker()

    /** In the order in which they came. */
    val messages = Channel<WorkerMessage>(Channel.UNLIMITED)

    init {
        listen(worker) { kind, text -> messages.trySend(WorkerMessage(kind, text)) }
    }

    fun send(text: String) = post(worker, text)

    fun close() {
        terminate(worker)
        messages.close()
    }
}

private fun openWorker(): JsAny = js("globalThis.robotranPage.openWorker()")

private fun listen(worker: JsAny, take: (String, String) -> Unit): Unit = js(
    """{
        worker.onmessage = ({ data }) => take(data.kind, data.text);
        worker.onerror = (event) => { event.preventDefault(); take('failed', String(event.message)); };
    }""",
)

private fun post(worker: JsAny, text: String): Unit = js("worker.postMessage(text)")

private fun terminate(worker: JsAny): Unit = js("worker.terminate()")
