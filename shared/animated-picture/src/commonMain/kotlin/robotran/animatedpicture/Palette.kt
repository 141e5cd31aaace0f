package robotran.animatedpicture

/**
 * At most [MAX_COLOURS] colours that stand for all colours of an animation.
 *
 * @property colours `0xRRGGBB` each.
 */
internal class Palette(val colours: IntArray) {
    private val cachedColours = IntArray(CACHE) { -1 }
    private val cachedIndices = IntArray(CACHE)

    /** The index of the colour nearest to [colour]. */
    fun indexOf(colour: Int): Int {
        val wanted = colour and RGB
        val place = (wanted xor (wanted ushr CACHE_SHIFT)) and (CACHE - 1)
        if (cachedColours[place] != wanted) {
            cachedIndices[place] = nearest(wanted)
            cachedColours[place] = wanted
        }
        return cachedIndices[place]
    }

    private fun nearest(wanted: Int): Int {
        var best = 0
        var bestDistance = Int.MAX_VALUE
        for (index in colours.indices) {
            val distance = distance(colours[index], wanted)
            if (distance < bestDistance) {
                best = index
                bestDistance = distance
            }
        }
        return best
    }

    companion object {
        /** One of the 256 indices of a GIF stands for "as before". */
        const val MAX_COLOURS = 255

        private const val CACHE = 16_384
        private const val CACHE_SHIFT = 10
    }
}

/** The squared distance of two colours, weighted by the eye's sensitivity. */
private fun distance(one: Int, other: Int): Int {
    val red = red(one) - red(other)
    val green = green(one) - green(other)
    val blue = blue(one) - blue(other)
    return RED_WEIGHT * red * red + GREEN_WEIGHT * green * green + BLUE_WEIGHT * blue * blue
}

internal fun red(colour: Int): Int = colour shr RED_SHIFT and CHANNEL

internal fun green(colour: Int): Int = colour shr GREEN_SHIFT and CHANNEL

internal fun blue(colour: Int): Int = colour and CHANNEL

internal const val RED_SHIFT = 16
internal const val GREEN_SHIFT = 8
internal const val CHANNEL = 0xFF

/** Rounded from the luma of ITU-R BT.601. */
private const val RED_WEIGHT = 3
private const val GREEN_WEIGHT = 6
private const val BLUE_WEIGHT = 1
