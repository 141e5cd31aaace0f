package robotran.workshop.platform

import kotlinx.coroutines.channels.Channel

/**
 * Files and links from outside: passed at start, dropped on the window or sent by another app.
 *
 * [bring] is thread-safe.
 */
class OpenRequests {
    private val waiting = Channel<OpenRequest>(Channel.UNLIMITED)

    fun bring(arrival: OpenRequest) {
        waiting.trySend(arrival)
    }

    /** The next pending request; null if there is none. */
    internal fun takeNow(): OpenRequest? = waiting.tryReceive().getOrNull()

    /** Waits for the next request. */
    internal suspend fun take(): OpenRequest = waiting.receive()
}

/** Files or a link to open together. */
sealed interface OpenRequest {
    data class OfFiles(val files: List<OpenedFile>) : OpenRequest

    data class OfLink(val link: String) : OpenRequest

    /** A file could not be read; [sentence] is the error message. */
    data class Unreadable(val sentence: String) : OpenRequest
}
