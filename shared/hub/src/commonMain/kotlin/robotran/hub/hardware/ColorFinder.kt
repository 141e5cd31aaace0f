package robotran.hub.hardware

import robotran.hub.model.HubColor
import robotran.hub.program.HubReading
import kotlin.math.abs

/** Finds the colour that a sensor sees among those that it is to tell apart, as Pybricks does for full colours and greys. */
internal object ColorFinder {
    private const val FULL = 100
    private const val CIRCLE = 360
    private const val SIXTH = 60
    private const val GREEN_AT = 120
    private const val BLUE_AT = 240

    /** Less saturated than this is grey. */
    private const val GREY_SATURATION = 40

    fun find(reading: HubReading.Light, among: List<HubColor>): HubColor {
        val highest = maxOf(reading.red, reading.green, reading.blue)
        val lowest = minOf(reading.red, reading.green, reading.blue)
        val raw = highest * FULL / HubReading.BRIGHTEST
        val plain = if (highest == 0) 0 else (highest - lowest) * FULL / highest
        val saturation = plain * (2 * FULL - plain) / FULL
        val value = raw * (3 * FULL - raw) / (2 * FULL)
        val isGrey = saturation <= GREY_SATURATION || value <= 1
        val greys = among.filter { it.isGrey }
        val colours = among - greys.toSet()
        if (isGrey && greys.isNotEmpty()) return greys.minBy { abs(it.value - value) }
        val hue = hue(reading, highest, highest - lowest)
        return colours.minByOrNull { apart(it.hue, hue) } ?: greys.minByOrNull { abs(it.value - value) }
            ?: HubColor.NONE
    }

    private fun hue(reading: HubReading.Light, highest: Int, spread: Int): Int = when {
        spread == 0 -> 0
        highest == reading.red -> (CIRCLE + SIXTH * (reading.green - reading.blue) / spread) % CIRCLE
        highest == reading.green -> GREEN_AT + SIXTH * (reading.blue - reading.red) / spread
        else -> BLUE_AT + SIXTH * (reading.red - reading.green) / spread
    }

    private fun apart(one: Int, other: Int): Int = abs(one - other).let { minOf(it, CIRCLE - it) }
}
