package robotran.rcxrom.sensors

/**
 * Converts raw values of the brick's analogue converter to battery voltages. Sources: leJOS `Battery.java` and `rom.h`
 * (43988 / 1560 millivolts a unit), `main.c` (100 / 355 tenths of a volt a unit on the screen of the shell).
 */
object Battery {
    /** The raw value of six fresh cells, 9.0 volts. */
    const val FULL_RAW = 320

    /** Millivolts of a raw value, 0..1023, computed like josx `Battery.getVoltageMilliVolt`. */
    fun millivolts(raw: Int): Int = raw * MILLIVOLT_FACTOR / MILLIVOLT_DIVISOR

    /** The lowest raw value, up to 1023, that gives at least [millivolts]. */
    fun rawOf(millivolts: Int): Int =
        (0..SensorCode.OPEN_RAW).firstOrNull { millivolts(it) >= millivolts } ?: SensorCode.OPEN_RAW

    /** The value on the shell's screen, in tenths of a volt. */
    fun screenTenths(raw: Int): Int = raw * SCREEN_FACTOR / SCREEN_DIVISOR

    private const val MILLIVOLT_FACTOR = 43988
    private const val MILLIVOLT_DIVISOR = 1560
    private const val SCREEN_FACTOR = 100
    private const val SCREEN_DIVISOR = 355
}
