package robotran.rcxrom.sensors

/**
 * What the brick's analogue converter makes of its battery. Sources: leJOS `Battery.java` and `rom.h` (43988 / 1560
 * millivolts a unit), `main.c` (100 / 355 tenths of a volt a unit on the screen of the shell).
 */
object Battery {
    /** The raw value of six fresh cells, 9.0 volts. */
    const val FULL_RAW = 320

    /** Millivolts of a raw value, 0..1023, as josx `Battery.getVoltageMilliVolt` works them out. */
    fun millivolts(raw: Int): Int = raw * MILLIVOLT_FACTOR / MILLIVOLT_DIVISOR

    /** The lowest raw value, up to 1023, of so many millivolts or more. */
    fun rawOf(millivolts: Int): Int =
        (0..SensorCode.OPEN_RAW).firstOrNull { millivolts(it) >= millivolts } ?: SensorCode.OPEN_RAW

    /** What the shell's screen shows, in tenths of a volt. */
    fun screenTenths(raw: Int): Int = raw * SCREEN_FACTOR / SCREEN_DIVISOR

    private const val MILLIVOLT_FACTOR = 43988
    private const val MILLIVOLT_DIVISOR = 1560
    private const val SCREEN_FACTOR = 100
    private const val SCREEN_DIVISOR = 355
}
