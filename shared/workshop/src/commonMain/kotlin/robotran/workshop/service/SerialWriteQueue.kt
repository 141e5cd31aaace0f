package robotran.workshop.service

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch

/** Writes small values asynchronously, in the order of the changes. */
internal class SerialWriteQueue(private val scope: CoroutineScope) {
    private var last: Job? = null

    /** Runs [write] after all earlier writes. */
    fun add(write: suspend () -> Unit) {
        val before = last
        last = scope.launch {
            before?.join()
            write()
        }
    }

    /** Waits until all writes are done. */
    suspend fun finish() {
        last?.join()
    }
}
