package robotran.simulation.nxt

import robotran.nxt.hardware.Clock
import robotran.nxt.hardware.NxtColour

/**
 * The colour sensor of HiTechnic: a number of eighteen colours, and how red, green and blue it is. It measures a hundred
 * times a second.
 */
internal class ColourDevice(private val eye: ColourSensorModel, private val clock: Clock) :
    RegisterDevice("V1.2", "HiTechnc", "Color") {
    private var seen = NxtColour(0, 0, 0, 0)

    override var hasMeasured = false
        private set

    override val reading: Int get() = HitechnicColours.numberOf(seen)

    override fun tick() {
        if (hasMeasured && clock.milliseconds() % PERIOD != 0L) return
        hasMeasured = true
        seen = eye.colour()
    }

    override fun measure() {
        val raw = listOf(seen.red, seen.green, seen.blue)
        val parts = raw.map { it shr BYTE_SHIFT }
        val brightest = parts.max()
        put(DATA, HitechnicColours.numberOf(seen))
        for (part in parts.indices) {
            put(PARTS + part, parts[part])
            putHigh(RAW + 2 * part, raw[part])
            put(NORMALIZED + part, if (brightest == 0) 0 else parts[part] * BYTE / brightest)
        }
        put(INDEX, parts.fold(0) { index, part -> index shl INDEX_BITS or (part shr BYTE_TO_INDEX) })
    }

    private companion object {
        const val PERIOD = 10L
        const val BYTE_SHIFT = 2
        const val INDEX_BITS = 2
        const val BYTE_TO_INDEX = 6

        // Registers. Source: HiTechnic's table, as leJOS NXJ reads them.
        const val PARTS = 0x43
        const val RAW = 0x46
        const val INDEX = 0x4C
        const val NORMALIZED = 0x4D
    }
}

/** The numbers by which the colour sensor of HiTechnic tells colours, from its chart. The limits are estimates. */
internal object HitechnicColours {
    private const val BLACK = 0
    private const val WHITE = 17

    /** A number for all colours up to a hue, in degrees. */
    private class Span(val upTo: Int, val bright: Int, val pale: Int)

    private val SPANS = listOf(
        Span(15, bright = 8, pale = 14),
        Span(40, bright = 7, pale = 13),
        Span(65, bright = 6, pale = 12),
        Span(95, bright = 5, pale = 12),
        Span(175, bright = 4, pale = 12),
        Span(250, bright = 3, pale = 11),
        Span(270, bright = 2, pale = 11),
        Span(290, bright = 1, pale = 11),
        Span(325, bright = 10, pale = 16),
        Span(345, bright = 9, pale = 15),
        Span(360, bright = 8, pale = 14),
    )

    /** 0 black, 3 blue, 4 green, 6 yellow, 7 orange, 8 red, 17 white. */
    fun numberOf(colour: NxtColour): Int {
        val brightest = maxOf(colour.red, colour.green, colour.blue)
        val difference = brightest - minOf(colour.red, colour.green, colour.blue)
        return when {
            brightest < BLACK_BELOW -> BLACK
            difference * GREY_PART < brightest -> if (brightest < WHITE_FROM) BLACK else WHITE

            else -> {
                val hue = hue(colour, brightest, difference)
                val span = SPANS.first { hue <= it.upTo }
                if (difference * 2 < brightest) span.pale else span.bright
            }
        }
    }

    /** In degrees, 0 red, 120 green, 240 blue. */
    private fun hue(colour: NxtColour, brightest: Int, difference: Int): Int = when (brightest) {
        colour.red -> (SIXTH * (colour.green - colour.blue) / difference).mod(CIRCLE)
        colour.green -> 2 * SIXTH + SIXTH * (colour.blue - colour.red) / difference
        else -> 2 * 2 * SIXTH + SIXTH * (colour.red - colour.green) / difference
    }

    // Of 1023, and parts.
    private const val BLACK_BELOW = 240
    private const val WHITE_FROM = 440
    private const val GREY_PART = 5
    private const val SIXTH = 60
    private const val CIRCLE = 360
}
