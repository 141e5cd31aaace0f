package robotran.workshop.platform

import kotlinx.coroutines.channels.Channel

/**
 * What is brought to a window from outside: files named at its start, dropped on it or handed over by another app, and
 * links.
 *
 * [bring] may be called from any thread.
 */
class OpenRequests {
    private val waiting = Channel<OpenRequest>(Channel.UNLIMITED)

    fun bring(arrival: OpenRequest) {
        waiting.trySend(arrival)
    }

    /** What has come already, null if nothing has. */
    internal fun takeNow(): OpenRequest? = waiting.tryReceive().getOrNull()

    /** The next that comes. */
    internal suspend fun take(): OpenRequest = waiting.receive()
}

/** What came together. */
sealed interface OpenRequest {
    data class OfFiles(val files: List<OpenedFile>) : OpenRequest

    data class OfLink(val link: String) : OpenRequest

    /** Something came that could not be read; [sentence] says why. */
    data class Unreadable(val sentence: String) : OpenRequest
}
