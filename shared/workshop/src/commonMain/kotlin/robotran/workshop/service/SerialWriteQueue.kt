package robotran.workshop.service

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch

/** Writes small things in the order in which they were changed, while the pupil goes on. */
internal class SerialWriteQueue(private val scope: CoroutineScope) {
    private var last: Job? = null

    /** Does [write] once all earlier ones are done. */
    fun add(write: suspend () -> Unit) {
        val before = last
        last = scope.launch {
            before?.join()
            write()
        }
    }

    /** Waits until nothing is left to be written. */
    suspend fun finish() {
        last?.join()
    }
}
