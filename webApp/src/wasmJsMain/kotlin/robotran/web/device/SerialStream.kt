@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.device

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.tower.port.ReceivedBytes

/** The bytes of [port], which is open, in both directions. */
internal class SerialStream(private val port: SerialPort) {
    private val received = ReceivedBytes()
    private var reader: StreamReader? = null
    private var isClosed = false
    private val reading = CoroutineScope(Dispatchers.Default).launch { readAll() }

    /** Hands over [bytes] for sending. False if the port is gone. */
    suspend fun send(bytes: ByteArray): Boolean {
        val writer = port.writable?.takeUnless { isClosed }?.getWriter() ?: return false
        val outcome = writer.write(bytes.toJs()).outcome()
        writer.releaseLock()
        return outcome.error == null
    }

    /** Suspends until something has come, and returns all of it; null once the port is gone. */
    suspend fun receive(): ByteArray? = received.take()

    /** Releases the port. Calling it again does nothing. */
    suspend fun close() {
        if (isClosed) return
        isClosed = true
        // Ends the read that is under way. A locked port cannot be closed.
        reader?.cancel()?.outcome()
        reading.join()
        port.close().outcome()
    }

    /**
     * A damaged byte (ParityError, FramingError) ends a reader, and the port offers a new stream; without one the device
     * is gone.
     */
    private suspend fun readAll() {
        while (!isClosed) {
            val next = port.readable?.getReader() ?: break
            reader = next
            readWith(next)
            reader = null
            next.releaseLock()
        }
        received.end()
    }

    private suspend fun readWith(reader: StreamReader) {
        while (true) {
            val part = reader.read().outcome()
            if (part.error != null || part.value.done) return
            part.value.value?.let { received.add(it.toByteArray()) }
        }
    }
}
