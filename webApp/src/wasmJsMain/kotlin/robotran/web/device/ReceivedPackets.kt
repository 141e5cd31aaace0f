package robotran.web.device

import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.first

/** Packets that a device has sent and nobody has taken yet. A page has one thread. */
internal class ReceivedPackets {
    private val packets = ArrayDeque<ByteArray>()
    private var isOver = false
    private val changes = MutableStateFlow(0)

    fun add(packet: ByteArray) {
        // A device that sends without end must not fill the memory while nobody reads.
        if (packets.size == MOST) packets.removeFirst()
        packets += packet
        changes.value++
    }

    /** Says that nothing more will come. */
    fun end() {
        isOver = true
        changes.value++
    }

    /** Suspends until there is a packet, and takes it; null after the last one. A cancelled call loses none. */
    suspend fun take(): ByteArray? {
        changes.first { packets.isNotEmpty() || isOver }
        return packets.removeFirstOrNull()
    }

    private companion object {
        const val MOST = 4_096
    }
}
