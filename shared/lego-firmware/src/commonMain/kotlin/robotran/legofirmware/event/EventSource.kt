package robotran.legofirmware.event

/** What events look at; the numbers are those of `sete`. */
internal sealed interface EventSource {
    data class Sensor(val port: Int) : EventSource

    data class Timer(val number: Int) : EventSource

    data object Message : EventSource

    data class Counter(val number: Int) : EventSource

    companion object {
        private const val FIRST_TIMER = 3
        private const val MESSAGE = 7
        private const val FIRST_COUNTER = 8
        private const val LAST_COUNTER = 10

        /** Null if there is no source with this number. */
        fun of(number: Int): EventSource? = when (number) {
            in 0 until FIRST_TIMER -> Sensor(number)
            in FIRST_TIMER until MESSAGE -> Timer(number - FIRST_TIMER)
            MESSAGE -> Message
            in FIRST_COUNTER..LAST_COUNTER -> Counter(number - FIRST_COUNTER)
            else -> null
        }
    }
}

/** When events fire; the numbers are those of `sete`. */
internal enum class EventType(val code: Int) {
    PRESSED(0),
    RELEASED(1),
    PULSE(2),
    EDGE(3),
    FAST_CHANGE(7),
    LOW(8),
    NORMAL(9),
    HIGH(10),
    CLICK(11),
    DOUBLE_CLICK(12),
    MESSAGE(14),
    ;

    companion object {
        fun of(code: Int): EventType? = entries.find { it.code == code }
    }
}

/** The range in which a value is; [code] is what a program reads. */
internal enum class EventState(val code: Int) {
    LOW(0),
    NORMAL(1),
    HIGH(2),
    UNDEFINED(3),
    CALIBRATION_BEGINS(4),
    CALIBRATING(5),
}
