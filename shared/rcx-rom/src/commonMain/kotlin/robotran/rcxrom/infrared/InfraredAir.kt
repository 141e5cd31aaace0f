package robotran.rcxrom.infrared

/**
 * The medium between bricks. Light arrives at all other ports within [reach], one millisecond after its last bit. Bytes
 * that overlap in time arrive damaged. All bricks and towers in the same air must be ticked together, once each a
 * millisecond.
 */
class InfraredAir(private val reach: InfraredReach = InfraredReach.EVERYWHERE) {
    private val ports = mutableListOf<InfraredPort>()

    /**
     * Adds a tower, such as the one connected to a computer, or a remote control.
     *
     * @param echoes whether it sends each message it hears back, to test a single brick.
     */
    fun placeTower(echoes: Boolean = false): InfraredTower = InfraredTower(open(), echoes)

    /** Adds a device that sends and receives single bytes, such as the one that connects an NXT with RCXs. */
    fun placeAdapter(): InfraredAdapter = InfraredAdapter(open())

    /** Adds a port that sends and receives; ports are numbered from 0. */
    internal fun open(): InfraredPort = InfraredPort(this, ports.size).also { ports += it }

    internal fun carry(light: InfraredByte, sender: InfraredPort) {
        for (port in ports) {
            if (port !== sender && reach.reaches(sender.number, port.number, sender.range)) port.arrive(light)
        }
    }

    /** Whether another light that [receiver] sees was on at the same time. */
    internal fun disturbs(light: InfraredByte, receiver: InfraredPort): Boolean = ports.any {
        it !== receiver && it.number != light.sender && it.wasLit(light.begin, light.end) &&
            reach.reaches(it.number, receiver.number, it.range)
    }
}

/**
 * A byte as light.
 *
 * @property begin the millisecond of its first bit.
 * @property end the millisecond of its last bit.
 */
internal data class InfraredByte(val value: Int, val sender: Int, val begin: Long, val end: Long)
