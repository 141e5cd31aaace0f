package robotran.tower.port

/** An open tower: a stream of bytes in each direction. All functions are called from one coroutine at a time. */
interface TowerPort {
    val kind: TowerKind

    /**
     * Hands over [bytes] for sending, at most 600 of them. May return before they are on the line. False if the tower
     * is gone.
     */
    suspend fun send(bytes: ByteArray): Boolean

    /**
     * Suspends until at least one byte has come and returns all that have come; null once the tower is gone. If the
     * call is cancelled, no byte is lost: the next call returns it.
     */
    suspend fun receive(): ByteArray?

    /** Releases the tower. Calling it again does nothing. */
    suspend fun close()
}
