package robotran.rcxrom.infrared

/** The connection of a brick or a tower to the air. */
internal class InfraredPort(private val air: InfraredAir, val number: Int) {
    var range = InfraredRange.SHORT
    private val arrived = ArrayDeque<InfraredByte>()
    private var lightBegin = 0L
    private var lightEnd = 0L

    /** Switches the light on at [begin], until the [InfraredByte.end] of the last byte before the next call. */
    fun beginLight(begin: Long) {
        lightBegin = begin
        lightEnd = begin
    }

    /** Extends the light to [now]. */
    fun extendLight(now: Long) {
        lightEnd = now
    }

    fun send(value: Int, begin: Long, end: Long) = air.carry(InfraredByte(value, number, begin, end), this)

    fun arrive(light: InfraredByte) {
        if (arrived.size == KEPT) arrived.removeFirst()
        arrived.addLast(light)
    }

    /** The next byte whose light ended before [now], damaged or not; null if there is none. */
    fun hear(now: Long): ReceivedByte? {
        if ((arrived.firstOrNull() ?: return null).end >= now) return null
        val light = arrived.removeFirst()
        return ReceivedByte(light.value, damaged = air.disturbs(light, this))
    }

    /** Whether other light was seen here while the own light was on, between [begin] and [end]. */
    fun isDisturbed(begin: Long, end: Long): Boolean = air.disturbs(InfraredByte(0, number, begin, end), this)

    /** Whether light was on here at any time between [begin] and [end]. */
    fun wasLit(begin: Long, end: Long): Boolean = lightBegin < end && lightEnd > begin

    private companion object {
        /** More bytes than arrive in the millisecond between two reads, however many bricks there are. */
        const val KEPT = 100
    }
}

/** A received byte; [damaged] if its parity or its stop bit is wrong. */
internal data class ReceivedByte(val value: Int, val damaged: Boolean)
