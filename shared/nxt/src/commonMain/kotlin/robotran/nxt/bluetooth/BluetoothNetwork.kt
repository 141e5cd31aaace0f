package robotran.nxt.bluetooth

import robotran.nxt.hardware.Clock

/**
 * The radio between the NXTs of a world, and the cable from port 4 to port 4. Nothing gets lost, and every brick can hear
 * every other. All bricks must tick in the same order in each millisecond.
 */
class BluetoothNetwork {
    private val ports = mutableListOf<BluetoothPort>()

    /** Adds a brick that others know by [name]. */
    internal fun join(name: String, clock: Clock): BluetoothPort = BluetoothPort(name, this, clock).also { ports += it }

    /** The brick of another robot; null if there is none of this name. */
    internal fun find(name: String, asker: BluetoothPort): BluetoothPort? =
        ports.find { it !== asker && it.name == name }
}
