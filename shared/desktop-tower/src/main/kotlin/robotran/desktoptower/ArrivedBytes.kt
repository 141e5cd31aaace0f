package robotran.desktoptower

import kotlinx.coroutines.channels.Channel

/** Bytes that a thread reads and a coroutine takes. */
internal class ArrivedBytes {
    private val lock = Any()
    private val changed = Channel<Unit>(Channel.CONFLATED)
    private var bytes = ByteArray(0)
    private var hasEnded = false

    /** Called by the reading thread. */
    fun add(arrived: ByteArray) {
        synchronized(lock) { bytes += arrived }
        changed.trySend(Unit)
    }

    /** No more bytes will come. */
    fun end() {
        synchronized(lock) { hasEnded = true }
        changed.trySend(Unit)
    }

    /** See [robotran.tower.port.TowerPort.receive]. Bytes are taken without suspending, so that none is lost. */
    suspend fun take(): ByteArray? {
        while (true) {
            synchronized(lock) {
                if (bytes.isNotEmpty()) return bytes.also { bytes = ByteArray(0) }
                if (hasEnded) return null
            }
            changed.receive()
        }
    }
}
