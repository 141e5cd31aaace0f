package robotran.rcxrom.call

/** What a ROM routine is about; chooses entries of a log, see [RomLogFilter]. */
enum class RomGroup {
    SENSORS,
    MOTORS,
    BUTTONS,
    DISPLAY,
    SOUND,
    POWER,
    INFRARED,
    TIMER,

    /** Calls of addresses where no routine is known. */
    UNKNOWN,
    ;

    companion object {
        /**
         * What a call of [address] is about. Routine 0x327c, which also sets the pointer of the infrared, counts as
         * [SOUND].
         */
        fun of(address: Int): RomGroup = RomTable.find(address)?.group ?: UNKNOWN
    }
}
