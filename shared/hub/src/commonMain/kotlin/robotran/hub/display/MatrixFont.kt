package robotran.hub.display

/** Numbers and characters as lights of a matrix. */
internal object MatrixFont {
    /** The characters that can be shown. */
    val PRINTABLE = 32..126

    private const val SIDE = 5
    private const val LIGHT = '#'
    private const val FULL = 100
    private const val HALF = 50
    private const val HIGHEST = 99
    private const val TEN = 10
    private const val SECOND_DIGIT = 3
    private const val MIDDLE = 2

    private val digits = glyphs(MatrixArt.DIGITS, width = 2)
    private val characters = glyphs(MatrixArt.CHARACTERS, SIDE)

    /** A matrix without lights. */
    val DARK: List<Int> = List(SIDE * SIDE) { 0 }

    fun has(character: Char): Boolean = character.code in PRINTABLE

    /** The brightnesses, 0..100, of a character that the font [has], row by row. */
    fun lightsOf(character: Char): List<Int> = characters[character.code - PRINTABLE.first]

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

    private fun glyphs(art: String, width: Int): List<List<Int>> =
        art.lines().filter { it.isNotEmpty() }.chunked(SIDE).flatMap { band ->
            List((band[0].length + 1) / (width + 1)) { glyph ->
                List(SIDE * width) { place ->
                    val x = glyph * (width + 1) + place % width
                    if (band[place / width][x] == LIGHT) FULL else 0
                }
            }
        }
}
