package robotran.android.hub

import robotran.hublink.connection.CommandAnswer
import robotran.hublink.connection.HubConnection
import robotran.hublink.connection.HubUuids
import robotran.hublink.connection.HubValue

/** A hub with Pybricks at the other end of [connection]; [name] is what it shows itself as. */
internal class GattHub(private val connection: GattConnection, private val name: String) : HubConnection {
    override val isSureOfPybricks: Boolean get() = true

    override suspend fun listen(take: (ByteArray) -> Unit) {
        for (event in connection.events) take(event)
    }

    override suspend fun read(value: HubValue): ByteArray? {
        val asked = connection.characteristic(serviceOf(value), HubUuids.of(value))
        val read = asked?.let { connection.read(it) }?.takeIf { it.isGood }?.value
        // Some devices keep the service with the name to themselves.
        return read ?: name.takeIf { value == HubValue.NAME && it.isNotEmpty() }?.encodeToByteArray()
    }

    override suspend fun subscribe(): Boolean = commands()?.let { connection.subscribe(it) } ?: false

    override suspend fun command(command: ByteArray): CommandAnswer {
        val answer = commands()?.let { connection.write(it, command) } ?: GattAnswer.GONE
        return when {
            connection.isGone || answer == GattAnswer.GONE -> CommandAnswer.Gone
            answer.isGood -> CommandAnswer.Accepted
            answer.status in ANDROIDS_OWN -> CommandAnswer.Unanswered
            else -> CommandAnswer.Refused(answer.status)
        }
    }

    override suspend fun close() = connection.close()

    private fun commands() = connection.characteristic(HubUuids.SERVICE, HubUuids.COMMANDS)

    private fun serviceOf(value: HubValue): String = when (value) {
        HubValue.NAME -> HubUuids.GENERIC_ACCESS
        HubValue.CAPABILITIES -> HubUuids.SERVICE
        HubValue.FIRMWARE, HubValue.PROFILE, HubValue.PNP_ID -> HubUuids.DEVICE_INFORMATION
    }

    private companion object {
        /** What Android says if something went wrong on its side: the hub may have heard the command. */
        val ANDROIDS_OWN = setOf(GattAnswer.NOT_BEGUN, 0x85, 0x101)
    }
}
