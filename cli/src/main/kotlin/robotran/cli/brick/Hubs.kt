package robotran.cli.brick

import robotran.desktoptower.hub.DesktopHubPorts
import robotran.hublink.connection.HubDevice
import robotran.hublink.connection.HubPorts

/**
 * Where commands find a hub.
 *
 * @property named the port that a user names.
 */
class Hubs(val ports: HubPorts, val named: (String) -> HubDevice) {
    companion object {
        /** The hubs of this machine. */
        fun ofThisMachine(): Hubs = DesktopHubPorts().let { Hubs(it, it::named) }
    }
}
