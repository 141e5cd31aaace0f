package robotran.nxt.bluetooth

import robotran.nxt.hardware.Clock

/** A brick in the [network], with the links of its program. */
internal class BluetoothPort(val name: String, private val network: BluetoothNetwork, private val clock: Clock) {
    private val opening = mutableListOf<Opening>()

    /** The links of the program so far, by their numbers. The list is new when one is added. */
    var links: List<BluetoothLink> = emptyList()
        private set

    /** Whether bytes are leaving by radio. */
    val isSending: Boolean get() = links.any { it.medium == LinkMedium.BLUETOOTH && it.isSending }

    fun knows(name: String): Boolean = network.find(name, this) != null

    /** Begins to connect to another robot. Returns the number of the link, -1 if there is no such robot. */
    fun open(name: String, medium: LinkMedium = LinkMedium.BLUETOOTH): Int {
        val other = network.find(name, this) ?: return -1
        val link = add(isListening = false, medium)
        opening += Opening(link, other, clock.milliseconds() + medium.connectMilliseconds)
        return link.number
    }

    /** Begins to wait for another robot. Returns the number of the link. */
    fun listen(medium: LinkMedium = LinkMedium.BLUETOOTH): Int = add(isListening = true, medium).number

    /** Connects what has taken long enough, or gives up if the other robot does not listen. */
    fun tick() {
        if (opening.isEmpty()) return
        for (attempt in opening.filter { it.endsAt <= clock.milliseconds() }) {
            opening -= attempt
            val listener = attempt.other.links.find {
                it.isListening && it.medium == attempt.link.medium && it.status == LinkStatus.WAITING
            }
            when {
                attempt.link.status == LinkStatus.CLOSED -> continue
                listener == null -> attempt.link.close()
                else -> attempt.link.connect(name, listener, attempt.other.name)
            }
        }
    }

    /** Closes and forgets all links. */
    fun reset() {
        links.forEach { it.close() }
        links = emptyList()
        opening.clear()
    }

    private fun add(isListening: Boolean, medium: LinkMedium): BluetoothLink {
        val link = BluetoothLink(links.size, isListening, medium, clock)
        links = links + link
        return link
    }

    private class Opening(val link: BluetoothLink, val other: BluetoothPort, val endsAt: Long)
}
