package robotran.nxt.hardware

/**
 * The events that a program waits for, at most [CAPACITY]. A machine registers them, polls once a millisecond, and
 * wakes the threads of those that have happened.
 */
class EventTable {
    private val events = arrayOfNulls<Event>(CAPACITY)

    /**
     * Looks for an event from now on.
     *
     * @param type [ANALOG_PORTS], [BUTTONS] or [SYSTEM]; others never happen.
     * @param filter the bits that count.
     * @param period milliseconds from one look to the next, at least 1.
     * @param view what can be seen now.
     * @return the number of the event, or -1 if there is no room.
     */
    fun register(type: Int, filter: Int, period: Int, view: EventView): Int {
        val number = events.indexOf(null)
        if (number >= 0) events[number] = Event(type, filter, maxOf(1, period)).apply { begin(view) }
        return number
    }

    /** Looks for the event no more. Returns whether it was being looked for. */
    fun unregister(number: Int): Boolean {
        if (events.getOrNull(number) == null) return false
        events[number] = null
        return true
    }

    /** Calls [happened] for each event whose time has come and of which bits have happened. */
    fun poll(view: EventView, happened: (number: Int, bits: Int) -> Unit) {
        for (number in events.indices) {
            val bits = events[number]?.look(view) ?: 0
            if (bits != 0) happened(number, bits)
        }
    }

    /** Whether any event of a type is being looked for. */
    fun has(type: Int): Boolean = events.any { it?.type == type }

    /** When the next look is due; null if nothing is looked for. */
    val nextLook: Long? get() = events.minOfOrNull { it?.nextLook ?: Long.MAX_VALUE }?.takeIf { it < Long.MAX_VALUE }

    private class Event(val type: Int, private val filter: Int, private val period: Int) {
        var nextLook = 0L
            private set
        private val analog = IntArray(SensorPort.PORTS)
        private var buttons = 0
        private var wasToEnd = false

        fun begin(view: EventView) {
            changes(view)
            nextLook = view.milliseconds + period
        }

        fun look(view: EventView): Int {
            if (view.milliseconds < nextLook) return 0
            nextLook = view.milliseconds + period
            return changes(view) and filter
        }

        private fun changes(view: EventView): Int = when (type) {
            ANALOG_PORTS -> changedPorts(view)
            BUTTONS -> changedButtons(view)
            SYSTEM -> changedSystem(view)
            else -> 0
        }

        private fun changedSystem(view: EventView): Int {
            val isNew = view.isToEnd && !wasToEnd
            wasToEnd = view.isToEnd
            return if (isNew) 1 else 0
        }

        private fun changedPorts(view: EventView): Int {
            var bits = 0
            for (port in analog.indices) {
                val value = view.analog(port)
                if (value != analog[port]) bits = bits or (1 shl port)
                analog[port] = value
            }
            return bits
        }

        private fun changedButtons(view: EventView): Int {
            val now = view.buttons()
            val before = buttons
            buttons = now
            return (now and before.inv()) or (before and now.inv() shl RELEASED_SHIFT)
        }
    }

    companion object {
        const val CAPACITY = 16

        /** Bits 0 to 3: the analog value of that port differs. */
        const val ANALOG_PORTS = 4

        /** Bits 0 to 3: a button was pressed, in the order of `buttons`; 8 to 11: it was released. */
        const val BUTTONS = 6

        /** Bit 0: the program is to end. */
        const val SYSTEM = 7

        private const val RELEASED_SHIFT = 8
    }
}

/** What the events of a brick are made of. */
interface EventView {
    val milliseconds: Long

    /** What the analog pin of [port], 0..3, measures. */
    fun analog(port: Int): Int

    /** The buttons that are down, as bits. */
    fun buttons(): Int

    /** Whether the program is to end. */
    val isToEnd: Boolean
}
