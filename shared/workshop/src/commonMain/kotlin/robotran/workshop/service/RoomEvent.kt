package robotran.workshop.service

/**
 * What has happened in one room that others may follow. A room knows no other room; it publishes and subscribes. Whoever
 * follows a room handles or names each of its events, so that the compiler points out a new one.
 */
sealed interface RoomEvent

/** Delivers each [RoomEvent] to all rooms, in the order in which they subscribed. */
class RoomEvents {
    private val subscribers = mutableListOf<(RoomEvent) -> Unit>()

    fun subscribe(subscriber: (RoomEvent) -> Unit) {
        subscribers += subscriber
    }

    fun publish(event: RoomEvent) = subscribers.forEach { it(event) }
}
