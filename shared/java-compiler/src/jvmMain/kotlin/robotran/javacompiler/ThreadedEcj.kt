package robotran.javacompiler

import kotlinx.coroutines.CompletableDeferred
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.completeWith
import kotlinx.coroutines.withContext
import kotlinx.coroutines.withTimeoutOrNull
import robotran.javacompiler.ecj.BrickTarget
import robotran.javacompiler.ecj.Ecj
import robotran.javacompiler.ecj.EcjCompilation
import robotran.javacompiler.ecj.TimedEcj
import robotran.javacompiler.messages.JavaMessages
import robotran.languagesupport.SourceFile
import kotlin.concurrent.thread

actual fun timedJavaCompiler(messages: JavaMessages): TimedJavaCompiler? =
    TimedJavaCompiler(ThreadedEcj(::JvmEcj), messages)

/**
 * ECJ in a thread for each compilation. One that takes too long is asked to end and is left alone: a thread cannot be
 * ended by force, but it has the lowest priority, and the next compilation has another compiler.
 *
 * @param fresh makes a compiler.
 */
internal class ThreadedEcj(private val fresh: () -> Ecj, private val maxTime: Long = TimedEcj.MAX_TIME) : TimedEcj() {
    private var ecj = fresh()

    override suspend fun compileNow(
        sources: List<SourceFile>,
        library: Map<String, ByteArray>,
        gaps: Set<String>,
        target: BrickTarget,
    ): EcjCompilation? {
        val own = ecj
        val result = CompletableDeferred<EcjCompilation>()
        val worker = thread(isDaemon = true, name = "Java compiler") {
            result.completeWith(runCatching { own.compile(sources, library, gaps, target) })
        }
        var hasEnded = false
        try {
            // In real time, whatever clock the caller's coroutines have.
            return withContext(Dispatchers.Default) { withTimeoutOrNull(maxTime) { result.await() } }
                .also { hasEnded = it != null }
        } catch (_: OutOfMemoryError) {
            return null
        } finally {
            if (!hasEnded) {
                ecj = fresh()
                worker.priority = Thread.MIN_PRIORITY
                worker.interrupt()
            }
        }
    }
}
