package robotran.hublink.connection

import robotran.hublink.HubError

/** How a hub is reached. */
enum class HubWay {
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
data class HubDevice(val id: String, val name: String, val way: HubWay)

/** The hubs of a machine, as far as its platform lets the app reach them. */
interface HubPorts {
    /** The ways that are open here; empty where the platform allows none, such as on an iPad. */
    val ways: Set<HubWay>

    /** Hubs that can be connected without asking the user. */
    suspend fun available(): List<HubDevice>

    /**
     * Asks the user for a hub by a dialog of the platform; null if the user cancels it. Browsers show the dialog only within
     * a few seconds of a click. Platforms without such a dialog return the first available hub.
     */
    suspend fun choose(way: HubWay): HubDevice?

    /** Connects [device]. */
    suspend fun open(device: HubDevice): OpenedHub
}

/** A platform that reaches no hub. */
object NoHubPorts : HubPorts {
    override val ways: Set<HubWay> get() = emptySet()

    override suspend fun available(): List<HubDevice> = emptyList()

    override suspend fun choose(way: HubWay): HubDevice? = null

    override suspend fun open(device: HubDevice): OpenedHub = OpenedHub.Failure(HubError.NotAllowed)
}
