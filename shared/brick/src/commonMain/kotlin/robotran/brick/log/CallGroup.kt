package robotran.brick.log

import robotran.rcxrom.call.RomTable

/** The subject of a ROM routine; [CallLogFilter] selects log entries by it. */
enum class CallGroup {
    SENSORS,
    MOTORS,
    BUTTONS,
    DISPLAY,
    SOUND,
    POWER,
    INFRARED,
    TIMER,

    /** Calls of addresses without a known routine. */
    UNKNOWN,
    ;

    companion object {
        /**
         * The group of the routine at [address]. Routine 0x327c, which also sets the infrared pointer, counts as
         * [SOUND].
         */
        fun of(address: Int): CallGroup = RomTable.find(address)?.group ?: UNKNOWN
    }
}
