package robotran.rcxrom.memory

/** Where our firmware keeps its own things, at the beginning of the memory that leJOS has for its firmware. */
internal object FirmwareMemory {
    /** A short for results of ROM calls. */
    const val RESULT = 0x8000

    /** The sensor table: three times seven bytes, and one more each so that shorts have even addresses. */
    const val SENSOR_TABLE = 0x8010
    const val SENSOR_ENTRY_BYTES = 8

    /** The flags that the ROM sets for the firmware's handlers, six bytes. */
    const val HANDLER_FLAGS = 0x8028

    /** The timers of [FirmwareTimers], 40 bytes. */
    const val TIMERS = 0x8030

    /** A message that the shell receives or answers with. */
    const val MESSAGE = 0x8060
}
