package robotran.rcxrom.sensors

/**
 * How the ROM converts a raw value; [code] is its number, to which a slope of 0..31 may be added. Source: leJOS
 * `SensorConstants.java`.
 */
enum class SensorMode(val code: Int) {
    /** The raw value itself. */
    RAW(0x00),

    /** 1 for a low raw value, otherwise 0. */
    BOOLEAN(0x20),

    /** Number of changes of the boolean value. */
    EDGE(0x40),

    /** Number of times the boolean value became 1. */
    PULSE(0x60),

    /** 0..101, higher with more light. */
    PERCENT(0x80),

    /** Tenths of a degree. */
    CELSIUS(0xA0),
    FAHRENHEIT(0xC0),

    /** Sixteenths of a turn, forwards positive. */
    ANGLE(0xE0),
    ;

    companion object {
        /** The mode in a byte of mode and slope. */
        fun of(modeAndSlope: Int): SensorMode = entries[(modeAndSlope and 0xE0) shr 5]
    }
}
