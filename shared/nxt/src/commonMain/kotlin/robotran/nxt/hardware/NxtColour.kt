package robotran.nxt.hardware

/**
 * What a colour sensor measures, each 0..1023.
 *
 * @property background the light without the sensor's lamp.
 */
data class NxtColour(val red: Int, val green: Int, val blue: Int, val background: Int) {
    /** The colour that leJOS NXJ's class library takes this for. */
    val kind: ColourKind
        get() {
            val (red, green, blue) = listOf(red, green, blue).map { it shr BYTE_SHIFT }
            val brightest = maxOf(red, green, blue)
            val darkest = minOf(red, green, blue)
            val near = brightest / NEAR_PART
            return when {
                brightest < BLACK_BELOW -> ColourKind.BLACK
                brightest - darkest < near -> if (brightest < WHITE_FROM) ColourKind.BLACK else ColourKind.WHITE
                brightest == blue -> ColourKind.BLUE
                isYellow(red, green, blue, near) -> ColourKind.YELLOW
                brightest == red -> ColourKind.RED
                else -> ColourKind.GREEN
            }
        }

    private fun isYellow(red: Int, green: Int, blue: Int, near: Int): Boolean {
        val difference = if (red > green) red - green else green - red
        return difference < maxOf(red, green, blue) / YELLOW_PART && minOf(red, green) - blue > near
    }

    private companion object {
        const val BYTE_SHIFT = 2

        // Of 255. They are those of the class library's SensorPort.
        const val BLACK_BELOW = 70
        const val WHITE_FROM = 110
        const val NEAR_PART = 4
        const val YELLOW_PART = 3
    }
}

/** The colours that a colour sensor tells apart; [code] is leJOS NXJ's number. */
enum class ColourKind(val code: Int) { BLACK(7), BLUE(2), GREEN(1), YELLOW(3), RED(0), WHITE(6) }
