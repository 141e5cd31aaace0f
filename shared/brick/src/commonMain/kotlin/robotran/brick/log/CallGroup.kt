package robotran.brick.log

/** The subject of a call; [CallLogFilter] selects log entries by it. */
enum class CallGroup {
    SENSORS,
    MOTORS,
    BUTTONS,
    DISPLAY,
    SOUND,
    POWER,
    INFRARED,
    TIMER,
    BLUETOOTH,

    /** Exits, exceptions and what a program prints. */
    SYSTEM,

    /** Calls of addresses without a known routine. */
    UNKNOWN,
    ;

    companion object {
        /** What every brick has. */
        val COMMON: List<CallGroup> = listOf(SENSORS, MOTORS, BUTTONS, DISPLAY, SOUND, POWER)
    }
}
