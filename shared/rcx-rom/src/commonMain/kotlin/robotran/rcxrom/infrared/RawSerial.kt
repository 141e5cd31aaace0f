package robotran.rcxrom.infrared

import robotran.rcxrom.clock.Clock
import robotran.rcxrom.memory.RcxMemory
import robotran.rcxrom.memory.SerialMemory

/**
 * The serial port in the hands of the firmware. A brick hears its own light: the firmware compares each byte that it
 * sent with what it hears at that time, and stops at the first difference. It keeps received bytes where the ROM has
 * its outgoing packet; if nobody reads them, byte 64 makes it forget all. Source: leJOS `llc.c`.
 *
 * @param prepare called before light is sent, so that it has the range that the program has set.
 */
internal class RawSerial(
    private val memory: RcxMemory,
    private val port: InfraredPort,
    private val clock: Clock,
    private val prepare: () -> Unit,
) : InfraredLine {
    private val unverified = ArrayDeque<LongRange>()
    private val sender = InfraredSender(port) { begin, end -> unverified.addLast(begin..end) }
    private var outstanding = 0
    private var first = 0
    private var next = 0

    /** Whether the firmware has the port. */
    var isActive = false
        private set

    override var hasCollided = false
        private set

    override val isSending: Boolean get() = outstanding > 0

    override fun begin() {
        end()
        hasCollided = false
        first = 0
        next = 0
        isActive = true
    }

    /** Gives the port back to the ROM. */
    fun end() {
        stop()
        isActive = false
    }

    override fun write(bytes: List<Int>) {
        stop()
        hasCollided = false
        if (!isActive) return
        outstanding = bytes.size
        prepare()
        sender.begin(clock.milliseconds(), bytes.size, bytes::get)
    }

    override fun read(): Int {
        if (first == next) return InfraredLine.NOTHING
        return memory.readByte(SerialMemory.OUTGOING + first).also { first = (first + 1) % SerialMemory.OUTGOING_BYTES }
    }

    /** Advances by the millisecond that ends at [now]. */
    fun tick(now: Long) {
        val wasSending = isSending
        verify(now)
        var byte = port.hear(now)
        while (byte != null) {
            if (!wasSending && !byte.damaged) keep(byte.value)
            byte = port.hear(now)
        }
        sender.tick(now)
    }

    /** Checks the bytes whose light ended before [now]: by then the light of all others is known, too. */
    private fun verify(now: Long) {
        while (unverified.isNotEmpty() && unverified.first().last < now) {
            val light = unverified.removeFirst()
            outstanding--
            if (!port.isDisturbed(light.first, light.last)) continue
            stop()
            hasCollided = true
        }
    }

    private fun keep(value: Int) {
        memory.writeByte(SerialMemory.OUTGOING + next, value)
        next = (next + 1) % SerialMemory.OUTGOING_BYTES
    }

    private fun stop() {
        sender.stop()
        unverified.clear()
        outstanding = 0
    }
}
