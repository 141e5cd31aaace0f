package robotran.nqc.config

/** The constants that make sense for a parameter of the API. Sources: those of the instructions. */
enum class ParameterLimit(val values: IntRange) {
    /** A sum of `OUT_A` 1, `OUT_B` 2 and `OUT_C` 4. */
    OUTPUTS(1..7),
    POWER(0..7),

    /** A system sound. */
    SOUND(0..5),

    /** Hz; 0 is a rest. Above, nobody hears anything. */
    FREQUENCY(0..20_000),

    /** In 10 ms, in one byte. */
    TONE_TIME(0..255),
    TIMER(0..3),
    COUNTER(0..2),
    EVENT(0..15),

    /** A message between bricks; 0 means none. */
    MESSAGE(1..255),
    PROGRAM(0..4),
    PRIORITY(0..255),
    HOUR(0..23),
    MINUTE(0..59),

    /** Minutes until the brick switches itself off. */
    SLEEP_TIME(0..255),

    /** In 10 ms. */
    WAIT(0..32_767),

    /** A view of the display. */
    DISPLAY(0..7),

    /** Decimal places. */
    DECIMALS(0..3),
    SENSOR_TYPE(0..4),

    /** Entries of the datalog, in 16 bits. */
    ENTRIES(0..65_535),
}
