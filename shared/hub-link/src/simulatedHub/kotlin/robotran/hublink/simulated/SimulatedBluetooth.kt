package robotran.hublink.simulated

import kotlinx.coroutines.channels.Channel
import kotlinx.coroutines.delay
import robotran.hublink.connection.CommandAnswer
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubValue

/** A hub over Bluetooth: events of at most 20 bytes, in order, none lost. */
class SimulatedBluetooth(private val hub: SimulatedHub, private val faults: WireFaults = WireFaults()) : HubConnection {
    override val isSureOfPybricks: Boolean get() = true

    /** All commands that arrived. */
    val commands = mutableListOf<ByteArray>()

    private val events = Channel<ByteArray>(Channel.UNLIMITED)
    private var isGone = false

    init {
        hub.listener = { event -> pieces(event).forEach { events.trySend(it) } }
    }

    override suspend fun listen(take: (ByteArray) -> Unit) {
        for (event in events) {
            delay(faults.delay())
            take(event)
        }
    }

    override suspend fun read(value: HubValue): ByteArray? {
        delay(faults.delay())
        return if (isGone) null else valueOf(hub.model, value)
    }

    override suspend fun subscribe(): Boolean {
        delay(faults.delay())
        if (!isGone) hub.subscribe(isOn = true)
        return !isGone
    }

    override suspend fun command(command: ByteArray): CommandAnswer {
        delay(faults.delay())
        if (isGone) return CommandAnswer.Gone
        if (faults.breaksNow()) {
            if (faults.doesLast) hub.command(command)
            disconnect()
            return CommandAnswer.Gone
        }
        commands += command
        val error = hub.command(command)
        delay(faults.delay())
        return when {
            isGone -> CommandAnswer.Gone
            error == 0 -> CommandAnswer.Accepted
            else -> CommandAnswer.Refused(error.takeUnless { faults.hidesReasons })
        }
    }

    override suspend fun close() = disconnect()

    /** Breaks the connection. */
    fun disconnect() {
        isGone = true
        hub.subscribe(isOn = false)
        events.close()
    }

    private companion object {
        const val LONGEST = 20

        /** Text is cut, wherever that is. */
        fun pieces(event: ByteArray): List<ByteArray> = if (event[0] != 1.toByte()) {
            listOf(event)
        } else {
            event.drop(1).chunked(LONGEST - 1).map { byteArrayOf(1) + it.toByteArray() }
        }
    }
}

/** What a hub of [model] tells as [value]. */
internal fun valueOf(model: SimulatedModel, value: HubValue): ByteArray = when (value) {
    HubValue.NAME -> model.name.encodeToByteArray()
    HubValue.FIRMWARE -> model.firmware.encodeToByteArray()
    HubValue.PROFILE -> model.profile.toString().encodeToByteArray()
    HubValue.PNP_ID -> model.pnpId
    HubValue.CAPABILITIES -> model.capabilities
}
