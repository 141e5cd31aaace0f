package robotran.workshop.platform

import kotlinx.coroutines.channels.Channel

/**
 * What is brought to a window from outside: files named at its start, dropped on it or handed over by another app, and links.
 *
 * [bring] may be called from any thread.
 */
class Arrivals {
    private val waiting = Channel<Arrival>(Channel.UNLIMITED)

    fun bring(arrival: Arrival) {
        waiting.trySend(arrival)
    }

    /** What has come already, null if nothing has. */
    internal fun takeNow(): Arrival? = waiting.tryReceive().getOrNull()

    /** The next that comes. */
    internal suspend fun take(): Arrival = waiting.receive()
}

/** What came together. */
sealed interface Arrival {
    data class OfFiles(val files: List<OpenedFile>) : Arrival

    data class OfLink(val link: String) : Arrival

    /** Something came that could not be read; [sentence] says why. */
    data class Unreadable(val sentence: String) : Arrival
}
