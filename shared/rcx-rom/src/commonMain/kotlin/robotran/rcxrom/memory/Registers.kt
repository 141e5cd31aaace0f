package robotran.rcxrom.memory

/**
 * The processor's pins and settings that are connected to something here. Pin settings are kept in memory, because the
 * processor cannot read its own. Sources: leJOS `rom.h`, brickEmu's ROM re-implementation.
 */
internal object Registers {
    /** Which pins of ports 5 and 6 are outputs. */
    const val PORT_5_DIRECTIONS = 0xFD84
    const val PORT_6_DIRECTIONS = 0xFD85

    /**
     * Bits of [PORT_6_DIRECTIONS]: the power of sensors 3, 2 and 1; an unknown pin; the loudspeaker; the display's two
     * wires.
     */
    const val SENSOR_PINS = 0x07
    const val UNKNOWN_PIN = 0x08
    const val SPEAKER_PIN = 0x10
    const val DISPLAY_PINS = 0x60

    /** Bit of [PORT_5_DIRECTIONS]: the memory's low-power mode. */
    const val MEMORY_POWER_PIN = 0x04

    /** Port 4: On-Off and Run (Run is inverted), and the infrared range. */
    const val PORT_4 = 0xFFB7
    const val RANGE_SHORT_BIT = 0x01
    const val ON_OFF_RELEASED_BIT = 0x02
    const val RUN_BIT = 0x04

    /** Port 7: View and Prgm. */
    const val PORT_7 = 0xFFBE
    const val VIEW_BIT = 0x40
    const val PRGM_BIT = 0x80

    /**
     * The 10-bit results of the analogue converter, in the upper bits of a word: ports 1, 2 and 3 at descending
     * addresses, the battery after them.
     */
    const val CONVERTER_OF_PORT_1 = 0xFFE4
    const val CONVERTER_OF_BATTERY = 0xFFE6
    const val CONVERTER_SHIFT = 6
}
