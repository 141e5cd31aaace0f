package robotran.rcxrom.infrared

/** Where a brick or a tower is in the air. */
internal class InfraredPort(private val air: InfraredAir, val number: Int) {
    var range = InfraredRange.SHORT
    private val arrived = ArrayDeque<InfraredByte>()
    private var lightBegin = 0L
    private var lightEnd = 0L

    /** Light goes out from [begin] until the [InfraredByte.end] of the last byte sent before the next begin. */
    fun beginLight(begin: Long) {
        lightBegin = begin
        lightEnd = begin
    }

    /** Light goes out up to [now]. */
    fun keepLight(now: Long) {
        lightEnd = now
    }

    fun send(value: Int, begin: Long, end: Long) = air.carry(InfraredByte(value, number, begin, end), this)

    fun arrive(light: InfraredByte) {
        if (arrived.size == KEPT) arrived.removeFirst()
        arrived.addLast(light)
    }

    /** The next byte whose light was over before [now], whether or not anything disturbed it; null if there is none. */
    fun hear(now: Long): ReceivedByte? {
        if ((arrived.firstOrNull() ?: return null).end >= now) return null
        val light = arrived.removeFirst()
        return ReceivedByte(light.value, damaged = air.disturbs(light, this))
    }

    /** Whether light went out from here at any time between [begin] and [end]. */
    fun shone(begin: Long, end: Long): Boolean = lightBegin < end && lightEnd > begin

    private companion object {
        /** More than come in the millisecond between two looks, however many bricks there are. */
        const val KEPT = 100
    }
}

/** A byte that has come out of the air; [damaged] if its parity or its end is wrong. */
internal data class ReceivedByte(val value: Int, val damaged: Boolean)
