package robotran.rcxrom.memory

/** Addresses of our firmware's own data, at the start of the memory that leJOS reserves for its firmware. */
internal object FirmwareMemory {
    /** A short for the results of ROM calls. */
    const val RESULT = 0x8000

    /** The sensor table: three times seven bytes, each padded by one so that shorts have even addresses. */
    const val SENSOR_TABLE = 0x8010
    const val SENSOR_ENTRY_BYTES = 8

    /** The flags that the ROM sets for the firmware's handlers, six bytes. */
    const val HANDLER_FLAGS = 0x8028

    /** The timers of [FirmwareTimers], 40 bytes. */
    const val TIMERS = 0x8030

    /** A message that the shell receives or sends. */
    const val MESSAGE = 0x8060
}
