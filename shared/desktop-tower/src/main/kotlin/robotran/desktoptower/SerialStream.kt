package robotran.desktoptower

import com.fazecast.jSerialComm.SerialPort
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.withContext
import robotran.tower.port.ReceivedBytes
import kotlin.concurrent.thread

/**
 * The bytes that go through an open serial [port], whose reads end after [READ_TIMEOUT].
 *
 * @param name of the thread that reads.
 */
internal class SerialStream(private val port: SerialPort, name: String) {
    private val received = ReceivedBytes()

    @Volatile
    private var isClosed = false

    @Volatile
    private var isUnplugged = false

    init {
        thread(isDaemon = true, name = name) { read() }
    }

    /** Sends [bytes]; false if the port is gone. */
    suspend fun send(bytes: ByteArray): Boolean = withContext(Dispatchers.IO) {
        !isClosed && !isUnplugged && port.writeBytes(bytes, bytes.size) == bytes.size
    }

    /** All that has come since the last call, at least a byte; null once the port is gone. */
    suspend fun receive(): ByteArray? = received.take()

    /** Releases the port. Calling it again does nothing. */
    suspend fun close() {
        if (isClosed) return
        isClosed = true
        withContext(Dispatchers.IO) { port.closePort() }
        received.end()
    }

    private fun read() {
        val buffer = ByteArray(BUFFER)
        while (!isClosed) {
            // A timeout gives 0, a port that was unplugged less.
            val count = port.readBytes(buffer, buffer.size)
            if (count < 0) break
            if (count > 0) received.add(buffer.copyOf(count))
        }
        isUnplugged = true
        received.end()
    }

    companion object {
        const val DATA_BITS = 8

        /** How often the reading thread looks whether the port was closed, in ms. */
        const val READ_TIMEOUT = 100
        private const val BUFFER = 1024
    }
}
