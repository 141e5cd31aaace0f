package robotran.hublink.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.hublink.connection.HubValue
import robotran.hublink.connection.PacketPort

/**
 * A hub at the packet interface of USB. Answers do not say what they answer.
 *
 * @param scope ends with the test, as `backgroundScope` of `runTest` does.
 */
class SimulatedPacketPort(
    scope: CoroutineScope,
    private val hub: SimulatedHub,
    private val faults: WireFaults = WireFaults(),
) : PacketPort {
    private val outgoing = Channel<ByteArray>(Channel.UNLIMITED)
    private val incoming = Channel<ByteArray>(Channel.UNLIMITED)
    private val onWire = Channel<ByteArray>(Channel.UNLIMITED)
    private var isGone = false

    init {
        hub.listener = { tell(byteArrayOf(2) + it) }
        scope.launch {
            for (packet in outgoing) {
                delay(faults.delay())
                hear(packet)
            }
        }
        scope.launch {
            for (packet in onWire) {
                delay(faults.delay())
                incoming.trySend(packet)
            }
            incoming.close()
        }
    }

    override suspend fun send(packet: ByteArray): Boolean {
        if (!isGone && !faults.isLost()) outgoing.trySend(packet)
        return !isGone
    }

    override suspend fun receive(): ByteArray? = incoming.receiveCatching().getOrNull()

    override suspend fun read(request: Int, value: Int): ByteArray? {
        delay(faults.delay())
        val asked = HubValue.entries.firstOrNull { it.service == request && it.number == value }
        return if (isGone) null else asked?.let { valueOf(hub.model, it) }
    }

    override suspend fun close() = unplug()

    /** Unplugs the hub. */
    fun unplug() {
        isGone = true
        hub.subscribe(isOn = false)
        onWire.close()
    }

    private fun hear(packet: ByteArray) {
        if (isGone || packet.size < 2) return
        if (packet[0] == 1.toByte()) {
            hub.subscribe(isOn = packet[1] == 1.toByte())
            return
        }
        val breaks = faults.breaksNow()
        if (!breaks || faults.doesLast) {
            tell(byteArrayOf(1) + numberBytes(hub.command(packet.copyOfRange(1, packet.size)).toLong(), 4))
        }
        if (breaks) unplug()
    }

    private fun tell(packet: ByteArray) {
        if (!isGone && !faults.isLost()) onWire.trySend(packet)
    }
}
