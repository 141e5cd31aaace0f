package robotran.hublink.connection

import robotran.hublink.HubError

/** How a hub is reached. */
enum class HubTransport {
    BLUETOOTH,

    /** The serial port of firmware 4.1 (profile 1.6). */
    USB_SERIAL,

    /** The packets of firmware 4.0 (profile 1.5), on EV3 and NXT. */
    USB_PACKETS,
}

/**
 * A hub that can be connected.
 *
 * @property id what [HubPorts.open] needs to find it. It is only valid for the platform that gave it.
 * @property name what the system shows for it; may be empty.
 */
data class HubDevice(val id: String, val name: String, val transport: HubTransport)

/** The hubs of a machine, as far as its platform lets the app reach them. */
interface HubPorts {
    /** The transports that the platform has; empty where the platform allows none, such as on an iPad. */
    val transports: Set<HubTransport>

    /** Hubs that can be connected without asking the user. */
    suspend fun available(): List<HubDevice>

    /**
     * Asks the user for a hub by a dialog of the platform. Browsers show the dialog only within a few seconds of a click.
     * Platforms without such a dialog return the first available hub.
     */
    suspend fun choose(transport: HubTransport): ChosenHub

    /** Connects [device]. */
    suspend fun open(device: HubDevice): OpenedHub
}

/** What came of asking for a hub. */
sealed interface ChosenHub {
    data class Chosen(val device: HubDevice) : ChosenHub

    /** The user has cancelled, no hub is there, or it is not clear which one is meant. */
    data object None : ChosenHub

    /** The user or the system does not let the app look for hubs. */
    data class Refused(val error: HubError) : ChosenHub

    companion object {
        /** [device], or [None] if it is null. */
        fun of(device: HubDevice?): ChosenHub = device?.let(::Chosen) ?: None
    }
}

/** A platform that reaches no hub. */
object NoHubPorts : HubPorts {
    override val transports: Set<HubTransport> get() = emptySet()

    override suspend fun available(): List<HubDevice> = emptyList()

    override suspend fun choose(transport: HubTransport): ChosenHub = ChosenHub.None

    override suspend fun open(device: HubDevice): OpenedHub = OpenedHub.Failure(HubError.NotAllowed)
}
