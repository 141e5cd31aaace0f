package robotran.rcxrom.infrared

/**
 * The air between bricks: what one sends comes to all others that [reach] lets see it, a millisecond after its last
 * bit. Bytes that meet others on their way arrive damaged. All bricks and towers in the same air must be ticked
 * together, once each a millisecond.
 */
class InfraredAir(private val reach: InfraredReach = InfraredReach.EVERYWHERE) {
    private val ports = mutableListOf<InfraredPort>()

    /**
     * A tower in this air, such as is connected to a computer, or a remote control.
     *
     * @param echoes whether it sends each message it hears back, so that a brick can be tried alone.
     */
    fun placeTower(echoes: Boolean = false): InfraredTower = InfraredTower(open(), echoes)

    /** A new place from which something sends and hears; they are numbered from 0. */
    internal fun open(): InfraredPort = InfraredPort(this, ports.size).also { ports += it }

    internal fun carry(light: InfraredByte, sender: InfraredPort) {
        for (port in ports) {
            if (port !== sender && reach.reaches(sender.number, port.number, sender.range)) port.arrive(light)
        }
    }

    /** Whether another light that [receiver] sees shone at the same time. */
    internal fun disturbs(light: InfraredByte, receiver: InfraredPort): Boolean = ports.any {
        it !== receiver && it.number != light.sender && it.shone(light.begin, light.end) &&
            reach.reaches(it.number, receiver.number, it.range)
    }
}

/**
 * A byte as light.
 *
 * @property begin the millisecond of its first bit.
 * @property end the millisecond of its last.
 */
internal data class InfraredByte(val value: Int, val sender: Int, val begin: Long, val end: Long)
