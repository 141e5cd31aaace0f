package robotran.rcxrom.sound

/**
 * The timer that generates tones. It counts a divided clock up to an integer, so only some frequencies are possible,
 * and few at the top of each band. Sources: the table at `play_sound_or_set_data_pointer` in leJOS `rom.h`, brickEmu's
 * ROM re-implementation.
 */
internal object ToneTimer {
    /** The processor's clock divided by two. */
    const val CLOCK_HERTZ = 8_000_000

    const val CONTROL_OF_1024 = 6
    const val CONTROL_OF_64 = 4
    const val CONTROL_OF_32 = 5

    /** The ROM's control value for sounds that need no clock. */
    const val CONTROL_OF_PAUSE = 7

    /** Clock divisors by control value; with any other value the timer stops. */
    private val DIVISOR_OF_CONTROL = mapOf(
        2 to 8,
        3 to 2,
        CONTROL_OF_64 to 64,
        CONTROL_OF_32 to 32,
        CONTROL_OF_1024 to 1024,
        7 to 256,
    )

    private val CONTROL_OF_BAND =
        listOf(
            31..122 to CONTROL_OF_1024,
            123..489 to 7,
            490..979 to CONTROL_OF_64,
            980..3921 to CONTROL_OF_32,
            3922..20_000 to 2,
        )

    /** The frequency of a timer that counts to [counts], 1..255; null if [control] stops it. */
    fun hertz(counts: Int, control: Int): Double? = DIVISOR_OF_CONTROL[control]?.let {
        CLOCK_HERTZ.toDouble() / it /
            counts
    }

    /**
     * The queue entry of the tone routine for [hertz] and a duration of 0..255; a silent pause if the timer cannot
     * reach [hertz].
     */
    fun sound(hertz: Int, duration: Int): Sound {
        val (_, control) = CONTROL_OF_BAND.find { (band, _) -> hertz in band }
            ?: return Sound(Sound.PAUSE, duration, CONTROL_OF_PAUSE)
        return Sound(CLOCK_HERTZ / DIVISOR_OF_CONTROL.getValue(control) / hertz, duration, control)
    }
}
