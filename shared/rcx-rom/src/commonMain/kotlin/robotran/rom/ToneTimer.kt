package robotran.rom

/**
 * The timer that makes tones: it counts a divided clock up to a whole number, so only some frequencies are possible, and few of them
 * at the top of each band. Source of the bands: the re-implemented ROM of brickEmu.
 */
internal object ToneTimer {
    /** The processor's clock divided by two. */
    const val CLOCK_HERTZ = 8_000_000

    private val DIVISOR_OF_BAND = listOf(31..122 to 1024, 123..489 to 256, 490..979 to 64, 980..3921 to 32, 3922..20_000 to 8)

    /** The frequency really given for [hertz]; null for those out of the timer's range, which are silent. */
    fun realHertz(hertz: Int): Double? {
        val (_, divisor) = DIVISOR_OF_BAND.find { (band, _) -> hertz in band } ?: return null
        val counts = CLOCK_HERTZ / divisor / hertz
        return CLOCK_HERTZ.toDouble() / divisor / counts
    }
}
