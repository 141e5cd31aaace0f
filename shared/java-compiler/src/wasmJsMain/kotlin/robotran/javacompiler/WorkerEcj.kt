@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.javacompiler

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.withTimeoutOrNull
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.EcjProblem
import robotran.javacompiler.ecj.TimedEcj
import robotran.javacompiler.messages.JavaMessages
import robotran.languagesupport.SourceFile

actual fun timedJavaCompiler(messages: JavaMessages): TimedJavaCompiler? =
    if (hasWorkers()) TimedJavaCompiler(worker, messages) else null

/** One for the whole page: each has a memory of its own. */
private val worker by lazy { WorkerEcj() }

/** ECJ in a worker of the browser, see `ecj-worker.mjs`. One that takes too long is ended, and the next gets another. */
private class WorkerEcj : TimedEcj() {
    private var open: EcjWorker? = null

    override suspend fun compileNow(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation? {
        val worker = open ?: EcjWorker().also { open = it }
        var isReady = false
        try {
            worker.ready()
            worker.send(request(worker, sources, library, gaps, target))
            // It may have ended for want of memory, and says nothing then.
            val reply = worker.next(TimedEcj.MAX_TIME) ?: return null
            if (reply.kind != COMPILED) return null
            isReady = true
            return compilationOf(reply)
        } finally {
            if (!isReady) {
                worker.close()
                open = null
            }
        }
    }

    private fun request(
        worker: EcjWorker,
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): JsAny {
        val request = newRequest(target.ordinal)
        gaps.forEach { addGap(request, it) }
        sources.forEach { addSource(request, it.name, it.text) }
        if (worker.libraries[target] !== library) {
            library.forEach { (name, bytes) -> addClass(request, name, bytes.toJsArray()) }
            worker.libraries[target] = library
        }
        return request
    }

    private fun compilationOf(reply: EcjReply): EcjCompilation {
        val classes = List(reply.classes.length) { checkNotNull(reply.classes[it]) }
        return EcjCompilation(
            classes.associate { it.name to byteArray(it.bytes) },
            classes.filter { it.hasMain }.map { it.name },
            List(reply.problems.length) { problemOf(checkNotNull(reply.problems[it])) },
            reply.completed,
        )
    }

    private fun problemOf(problem: EcjReplyProblem) = EcjProblem(
        path = problem.path,
        number = problem.number,
        isError = problem.isError,
        isSyntax = problem.isSyntax,
        start = problem.start,
        end = problem.end,
        message = problem.message,
        arguments = textsOf(problem.arguments),
        members = textsOf(problem.members),
    )

    private fun textsOf(texts: JsArray<JsString>) = List(texts.length) { texts[it].toString() }
}

/** @property libraries those that it has read. */
private class EcjWorker {
    private val worker = openWorker()
    private val replies = Channel<EcjReply>(Channel.UNLIMITED)
    private var isLoaded = false
    val libraries = mutableMapOf<BrickTarget, Map<String, ByteArray>>()

    init {
        listen(worker) { replies.trySend(it) }
    }

    /** Waits until ECJ is loaded, for which a slow network may need long. */
    suspend fun ready() {
        if (isLoaded) return
        val reply = replies.receive()
        if (reply.kind != READY) throw CompilerNotLoadedException(reply.text.orEmpty())
        isLoaded = true
    }

    /** The next reply within [milliseconds]. A machine that sleeps meanwhile does not count: each wait is short. */
    suspend fun next(milliseconds: Long): EcjReply? {
        repeat(WAITS) { withTimeoutOrNull(milliseconds / WAITS) { replies.receive() }?.let { return it } }
        return null
    }

    fun send(request: JsAny) = post(worker, request)

    fun close() = terminate(worker)

    private companion object {
        const val WAITS = 10
    }
}

private external interface EcjReply : JsAny {
    val kind: String
    val text: String?
    val completed: Boolean
    val classes: JsArray<EcjReplyClass>
    val problems: JsArray<EcjReplyProblem>
}

private external interface EcjReplyClass : JsAny {
    val name: String
    val bytes: JsAny
    val hasMain: Boolean
}

private external interface EcjReplyProblem : JsAny {
    val path: String
    val number: Int
    val isError: Boolean
    val isSyntax: Boolean
    val start: Int
    val end: Int
    val message: String
    val arguments: JsArray<JsString>
    val members: JsArray<JsString>
}

/** Whether this is a page that may have workers. A worker compiles by itself. */
private fun hasWorkers(): Boolean = js("typeof document !== 'undefined' && typeof Worker === 'function'")

/** Bundlers find the worker by this expression. */
private fun openWorker(): JsAny = js(
    "new Worker(/* webpackChunkName: 'ecj-worker' */ new URL('./ecj-worker.mjs', import.meta.url), { type: 'module' })",
)

private fun listen(worker: JsAny, take: (EcjReply) -> Unit): Unit = js(
    """{
        worker.onmessage = ({ data }) => take(data);
        worker.onerror = (event) => { event.preventDefault(); take({ kind: 'failed', text: String(event.message) }); };
    }""",
)

private fun newRequest(target: Int): JsAny = js("({ target, library: null, gaps: [], sources: [] })")

private fun addGap(request: JsAny, key: String): Unit = js("{ request.gaps.push(key); }")

private fun addSource(request: JsAny, path: String, text: String): Unit = js("{ request.sources.push([path, text]); }")

private fun addClass(request: JsAny, name: String, bytes: JsAny): Unit =
    js("{ (request.library ??= []).push([name, bytes]); }")

private fun post(worker: JsAny, request: JsAny): Unit = js("worker.postMessage(request)")

private fun terminate(worker: JsAny): Unit = js("worker.terminate()")

private const val READY = "ready"
private const val COMPILED = "compiled"
