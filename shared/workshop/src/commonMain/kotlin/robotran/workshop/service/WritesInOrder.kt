package robotran.workshop.service

import kotlinx.coroutines.Job
import kotlinx.coroutines.launch

/** Writes small things away in the order in which they were changed, while the pupil goes on. */
internal class WritesInOrder(private val bench: Bench) {
    private var last: Job? = null

    /** Does [write] once all earlier ones are done. */
    fun add(write: suspend () -> Unit) {
        val before = last
        last = bench.scope.launch {
            before?.join()
            write()
        }
    }

    /** Waits until nothing is left to be written. */
    suspend fun finish() {
        last?.join()
    }
}
