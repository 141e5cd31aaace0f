@file:OptIn(ExperimentalWasmJsInterop::class)

package robotran.web.tower

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.launch
import robotran.tower.port.ReceivedBytes
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort

/** A serial tower at [port], which is open. */
internal class WebSerialPort(private val port: SerialPort) : TowerPort {
    override val kind: TowerKind = TowerKind.SERIAL
    private val received = ReceivedBytes()
    private var reader: StreamReader? = null
    private var isClosed = false
    private val reading = CoroutineScope(Dispatchers.Default).launch { readAll() }

    override suspend fun send(bytes: ByteArray): Boolean {
        val writer = port.writable?.takeUnless { isClosed }?.getWriter() ?: return false
        val outcome = writer.write(bytes.toJs()).outcome()
        writer.releaseLock()
        return outcome.error == null
    }

    override suspend fun receive(): ByteArray? = received.take()

    override suspend fun close() {
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
