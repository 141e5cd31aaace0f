package robotran.hublink.simulated

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import robotran.hublink.connection.BytePort
import robotran.hublink.connection.HubValue
import robotran.hublink.frame.Cobs
import robotran.hublink.frame.FrameReader

/**
 * A hub at a serial port, with frames. Bytes come in pieces of any length.
 *
 * @param scope ends with the test, as `backgroundScope` of `runTest` does.
 */
class SimulatedSerialPort(
    scope: CoroutineScope,
    private val hub: SimulatedHub,
    private val faults: WireFaults = WireFaults(),
) : BytePort {
    private val outgoing = Channel<ByteArray>(Channel.UNLIMITED)
    private val incoming = Channel<ByteArray>(Channel.UNLIMITED)
    private val onWire = Channel<ByteArray>(Channel.UNLIMITED)
    private val reader = FrameReader()
    private var isGone = false

    init {
        hub.listener = { event -> pieces(event).forEach { tell(byteArrayOf(2) + it) } }
        scope.launch {
            for (bytes in outgoing) {
                delay(faults.delay())
                val messages = reader.add(bytes)
                // Of commands that come together, the firmware answers the last alone.
                messages.forEachIndexed { index, message -> hear(message, isLast = index == messages.lastIndex) }
            }
        }
        scope.launch {
            for (bytes in onWire) {
                delay(faults.delay())
                incoming.trySend(bytes)
            }
            incoming.close()
        }
    }

    override suspend fun send(bytes: ByteArray): Boolean {
        if (!isGone && !faults.isLost()) outgoing.trySend(bytes)
        return !isGone
    }

    override suspend fun receive(): ByteArray? = incoming.receiveCatching().getOrNull()

    override suspend fun close() = unplug()

    /** Unplugs the hub. */
    fun unplug() {
        isGone = true
        hub.subscribe(isOn = false)
        onWire.close()
    }

    private fun hear(message: ByteArray, isLast: Boolean) {
        if (isGone || message.size < 2) return
        when (message[0].toInt()) {
            1 -> hub.subscribe(isOn = message[1] == 1.toByte())

            2 -> {
                val command = message.copyOfRange(2, message.size)
                if (command.isEmpty()) return
                val breaks = faults.breaksNow()
                if (!breaks || faults.doesLast) {
                    val error = hub.command(command)
                    if (isLast) tell(byteArrayOf(1, message[1]) + numberBytes(error.toLong(), 4))
                }
                if (breaks) unplug()
            }

            3 -> if (message.size >= 4) read(message)
        }
    }

    private fun read(message: ByteArray) {
        val number = (message[2].toInt() and 0xFF) or ((message[3].toInt() and 0xFF) shl 8)
        val value = HubValue.entries.firstOrNull { it.service == message[1].toInt() && it.number == number }
        val model = hub.model.copy(messageBytes = minOf(hub.model.messageBytes, MESSAGE))
        tell(message.copyOf(4) + (value?.let { valueOf(model, it) } ?: ByteArray(0)))
    }

    private fun tell(message: ByteArray) {
        if (isGone || faults.isLost()) return
        val frame = Cobs.encode(message)
        val cut = frame.size / 2
        onWire.trySend(frame.copyOf(cut))
        onWire.trySend(frame.copyOfRange(cut, frame.size))
    }

    private companion object {
        /** The longest command over the serial line. */
        const val MESSAGE = 60

        fun pieces(event: ByteArray): List<ByteArray> = if (event[0] != 1.toByte()) {
            listOf(event)
        } else {
            event.drop(1).chunked(MESSAGE - 1).map { byteArrayOf(1) + it.toByteArray() }
        }
    }
}
