package robotran.tower.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.first
import kotlinx.coroutines.flow.getAndUpdate
import kotlinx.coroutines.flow.update
import kotlinx.coroutines.launch
import robotran.tower.port.TowerKind
import robotran.tower.port.TowerPort
import kotlin.time.Duration.Companion.milliseconds

/**
 * A tower with a brick in sight. Bytes take their time on the line, which is that of the coroutines in [scope]: virtual
 * in tests.
 *
 * @param scope ends with the test, as `backgroundScope` of `runTest` does.
 * @param kind a serial tower echoes, the USB tower does not and swallows the first byte of each answer.
 * @param hasEcho false for a serial port without tower.
 * @param speed how many times faster than 2400 baud the line is, for tests in real time.
 */
class SimulatedTower(
    scope: CoroutineScope,
    private val brick: SimulatedBrick,
    override val kind: TowerKind = TowerKind.SERIAL,
    private val faults: LineFaults = LineFaults(),
    private val hasEcho: Boolean = kind == TowerKind.SERIAL,
    private val speed: Int = 1,
) : TowerPort {
    /** All bytes that were handed over for sending, message by message. */
    val sent = mutableListOf<ByteArray>()

    /** Whether the port was closed. */
    var isClosed = false
        private set

    private val outgoing = Channel<ByteArray>(Channel.UNLIMITED)

    /** The line and who receives may be on different threads. */
    private val incoming = MutableStateFlow(Incoming())
    private var fraction = 0

    init {
        scope.launch { for (bytes in outgoing) carry(bytes) }
    }

    override suspend fun send(bytes: ByteArray): Boolean {
        if (incoming.value.hasEnded) return false
        sent += bytes
        outgoing.trySend(bytes)
        return true
    }

    override suspend fun receive(): ByteArray? {
        incoming.first { it.bytes.isNotEmpty() || it.hasEnded }
        val taken = incoming.getAndUpdate { it.copy(bytes = emptyList()) }.bytes
        return taken.toByteArray().takeIf { it.isNotEmpty() }
    }

    override suspend fun close() {
        isClosed = true
        unplug()
    }

    /** Unplugs the tower. */
    fun unplug() = incoming.update { it.copy(hasEnded = true) }

    /** The robot sends [bytes] by itself. */
    suspend fun robotSends(bytes: List<Byte>) = answer(framed(bytes))

    /** Bytes that nobody sent arrive: a lamp, or the rest of something. */
    fun noise(bytes: List<Byte>) = arrive(bytes)

    private suspend fun carry(bytes: ByteArray) {
        for (packet in bytes.toList().chunked(PACKET)) {
            onLine(packet.size)
            if (hasEcho) arrive(packet.flatMap(faults::pass))
            val heard = packet.flatMap(faults::pass)
            for (byte in heard) brick.hear(byte)?.let { answer(it) }
        }
    }

    private suspend fun answer(bytes: List<Byte>) {
        delay(TURNAROUND)
        bytes.chunked(PACKET).forEachIndexed { index, packet ->
            onLine(packet.size)
            val isSwallowed = index == 0 && kind == TowerKind.USB
            arrive(packet.drop(if (isSwallowed) 1 else 0).flatMap(faults::pass))
        }
    }

    /** The time of [bytes] at 2400 baud with 11 bits, and the delays of the line. */
    private suspend fun onLine(bytes: Int) {
        fraction += MICROSECONDS_OF_A_BYTE * bytes / speed
        val delays = (1..bytes).sumOf { faults.delay() }
        delay((fraction / 1000 + delays).milliseconds)
        fraction %= 1000
    }

    private fun arrive(bytes: List<Byte>) {
        if (bytes.isNotEmpty()) incoming.update { if (it.hasEnded) it else it.copy(bytes = it.bytes + bytes) }
    }

    /** What was heard and not received so far. */
    private data class Incoming(val bytes: List<Byte> = emptyList(), val hasEnded: Boolean = false)

    private companion object {
        /** Bytes that arrive at once, as the USB tower and serial adapters hand them over. */
        const val PACKET = 8
        const val MICROSECONDS_OF_A_BYTE = 4583

        /** The time that a brick takes to answer. */
        val TURNAROUND = 10.milliseconds
    }
}
