package robotran.hublink.connection

/** An open serial port with DTR on: a stream of bytes in each direction. */
interface BytePort {
    /** Hands over [bytes] for sending. False if the port is gone. */
    suspend fun send(bytes: ByteArray): Boolean

    /**
     * Suspends until at least one byte has come and returns all that have come; null once the port is gone. If the call is
     * cancelled, no byte is lost: the next call returns it.
     */
    suspend fun receive(): ByteArray?

    /** Releases the port. Calling it again does nothing. */
    suspend fun close()
}

/** An open interface of class FF, subclass C5, protocol F5: a bulk endpoint in each direction. */
interface PacketPort {
    /** Sends a packet. False if the hub is gone. */
    suspend fun send(packet: ByteArray): Boolean

    /** Suspends until a packet has come; null once the hub is gone. If the call is cancelled, no packet is lost. */
    suspend fun receive(): ByteArray?

    /** A control transfer in, of class and interface, with at most 20 bytes; null if the hub refuses it. */
    suspend fun read(request: Int, value: Int): ByteArray?

    /** Releases the interface. Calling it again does nothing. */
    suspend fun close()
}
