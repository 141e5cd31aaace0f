package robotran.microbitlink.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.microbitlink.dap.DapPort

/**
 * A board at USB.
 *
 * @param scope ends with the test, as `backgroundScope` of `runTest` does.
 */
class SimulatedDapPort(
    scope: CoroutineScope,
    private val board: SimulatedBoard,
    private val faults: CableFaults = CableFaults(),
) : DapPort {
    private val outgoing = Channel<ByteArray>(Channel.UNLIMITED)
    private val onWire = Channel<ByteArray>(Channel.UNLIMITED)
    private val incoming = Channel<ByteArray>(Channel.UNLIMITED)
    private var isGone = false

    /** How many packets the app has sent. */
    var packets = 0
        private set

    init {
        faults.staleAnswers.forEach { onWire.trySend(it) }
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
        check(packet.size == PACKET) { "A packet has $PACKET bytes." }
        packets++
        if (!isGone && !faults.isLost()) outgoing.trySend(packet)
        return !isGone
    }

    override suspend fun receive(): ByteArray? = incoming.receiveCatching().getOrNull()

    override suspend fun close() = unplug()

    /** Unplugs the board. */
    fun unplug() {
        isGone = true
        onWire.close()
    }

    private fun hear(packet: ByteArray) {
        if (isGone) return
        val unplugs = faults.unplugsNow()
        if (!unplugs || faults.doesLast) {
            val answer = board.answer(packet, faults)
            if (!faults.isLost()) onWire.trySend(answer.copyOf(PACKET))
        }
        if (unplugs) unplug()
    }

    private companion object {
        const val PACKET = 64
    }
}
