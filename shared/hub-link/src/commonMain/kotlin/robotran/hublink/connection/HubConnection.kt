package robotran.hublink.connection

import robotran.hublink.HubError

/**
 * An open connection to a hub. Bluetooth offers just this; [SerialHub] and [PacketHub] make it of what USB offers.
 *
 * Functions may be cancelled at any moment. [HubLink][robotran.hublink.hub.HubLink] gives one command at a time.
 */
interface HubConnection {
    /** Whether a hub that is connected this way, but answers nothing, has a firmware of LEGO's own. */
    val isSureOfPybricks: Boolean

    /**
     * Hands events of the hub, without anything in front, to [take] until the connection is gone. Nothing else works before
     * this runs. Only one call at a time.
     */
    suspend fun listen(take: (ByteArray) -> Unit)

    /** Reads [value]; null if the hub does not have it, or does not answer. */
    suspend fun read(value: HubValue): ByteArray?

    /** Asks for events. Nothing comes before. False if that fails. */
    suspend fun subscribe(): Boolean

    /** Sends [command] and waits for the answer. */
    suspend fun command(command: ByteArray): CommandAnswer

    /** Releases the hub. Calling it again does nothing. */
    suspend fun close()
}

/** What became of a command. */
sealed interface CommandAnswer {
    data object Accepted : CommandAnswer

    /** @property code the error, of Bluetooth's ATT or the same over USB; null where the system keeps it back. */
    data class Refused(val code: Int?) : CommandAnswer

    /** No answer came: the hub may have done it or not. */
    data object Unanswered : CommandAnswer

    /** The connection is gone: the hub may have done it or not. */
    data object Gone : CommandAnswer
}

/**
 * A value that a hub tells.
 *
 * @property service the kind of number on the serial line: 1 for GATT's own, 2 for those of Pybricks.
 * @property number the number of the characteristic: the first 16 bits behind the zeros of its UUID for GATT's own.
 */
enum class HubValue(val service: Int, val number: Int) {
    NAME(1, 0x2A00),
    FIRMWARE(1, 0x2A26),
    PROFILE(1, 0x2A28),
    PNP_ID(1, 0x2A50),
    CAPABILITIES(2, 0x0003),
}

/** The UUIDs of a hub with Pybricks. */
object HubUuids {
    /** In the advertisement. */
    const val SERVICE = "c5f50001-8280-46da-89f4-6d8051e4aeef"

    /** Commands, written with response, and events. */
    const val COMMANDS = "c5f50002-8280-46da-89f4-6d8051e4aeef"
    const val CAPABILITIES = "c5f50003-8280-46da-89f4-6d8051e4aeef"

    /** GATT's device information. */
    const val DEVICE_INFORMATION = "0000180a-0000-1000-8000-00805f9b34fb"

    /** GATT's service with the name. */
    const val GENERIC_ACCESS = "00001800-0000-1000-8000-00805f9b34fb"

    /** A SPIKE hub with LEGO's firmware 3. */
    const val LEGO_SERVICE = "0000fd02-0000-1000-8000-00805f9b34fb"

    /** The characteristic of [value]. */
    fun of(value: HubValue): String = when (value) {
        HubValue.CAPABILITIES -> CAPABILITIES
        else -> "0000${value.number.toString(HEXADECIMAL)}-0000-1000-8000-00805f9b34fb"
    }

    private const val HEXADECIMAL = 16
}

/** The result of opening a connection. */
sealed interface OpenedHub {
    data class Success(val connection: HubConnection) : OpenedHub

    data class Failure(val error: HubError) : OpenedHub
}
