package robotran.hub.display

import robotran.brick.lights.LightFont

/** Numbers and characters as lights of a matrix. */
internal object MatrixFont {
    private const val SIDE = LightFont.SIDE
    private const val FULL = 100
    private const val HALF = 50
    private const val HIGHEST = 99
    private const val TEN = 10
    private const val SECOND_DIGIT = 3
    private const val MIDDLE = 2

    private val digits = LightFont.glyphs(MatrixArt.DIGITS, width = 2).map(::brightnesses)

    /** A matrix without lights. */
    val DARK: List<Int> = List(SIDE * SIDE) { 0 }

    fun has(character: Char): Boolean = LightFont.has(character)

    /** The brightnesses, 0..100, of a character that the font [has], row by row. */
    fun lightsOf(character: Char): List<Int> = brightnesses(LightFont.lightsOf(character))

    /** The brightnesses for a number: two digits, a dot for a minus, and an arrow beyond 99. */
    fun lightsOf(number: Int): List<Int> {
        if (number > HIGHEST) return lightsOf('>')
        if (number < -HIGHEST) return lightsOf('<')
        val size = if (number < 0) -number else number
        val lights = DARK.toMutableList()
        for (row in 0..<SIDE) {
            for (column in 0..<2) {
                lights[row * SIDE + column] = digits[size / TEN][row * 2 + column]
                lights[row * SIDE + SECOND_DIGIT + column] = digits[size % TEN][row * 2 + column]
            }
        }
        if (number < 0) lights[MIDDLE * SIDE + MIDDLE] = HALF
        return lights
    }

    private fun brightnesses(lights: List<Boolean>) = lights.map { if (it) FULL else 0 }
}
