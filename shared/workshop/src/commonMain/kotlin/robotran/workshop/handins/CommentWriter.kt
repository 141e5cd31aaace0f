package robotran.workshop.handins

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.sync.Mutex
import kotlinx.coroutines.sync.withLock
import robotran.workshop.state.HandInsMessage

/** Keeps comments in the pauses of typing. */
internal class CommentWriter(private val scope: CoroutineScope, private val tell: (HandInsMessage) -> Unit) {
    private val writing = Mutex()
    private var next: Pair<KeptHandIns, Map<String, String>>? = null
    private var pause: Job? = null

    /** Keeps [comments], which are all, soon. */
    fun write(kept: KeptHandIns, comments: Map<String, String>) {
        next = kept to comments
        pause?.cancel()
        pause = scope.launch {
            delay(PAUSE_MILLISECONDS)
            scope.launch { saveNow() }
        }
    }

    /** Keeps what is not kept yet at once. */
    fun flush() {
        pause?.cancel()
        scope.launch { saveNow() }
    }

    /** Does not keep what is not kept yet. */
    fun forget() {
        pause?.cancel()
        next = null
    }

    suspend fun saveNow() = writing.withLock {
        val (kept, comments) = next ?: return@withLock
        next = null
        notKept(kept.write(comments))?.let(tell)
        Unit
    }

    private companion object {
        const val PAUSE_MILLISECONDS = 600L
    }
}
