package robotran.brick.lights

/** Characters as 5 by 5 lights. The shapes are our own. */
object LightFont {
    /** The characters that can be shown. */
    val PRINTABLE: IntRange = 32..126

    /** Lights in a row, and rows. */
    const val SIDE = 5

    private const val LIGHT = '#'
    private val characters = glyphs(CharacterArt.CHARACTERS, SIDE)

    fun has(character: Char): Boolean = character.code in PRINTABLE

    /** Which lights are on for a character that the font [has], row by row. */
    fun lightsOf(character: Char): List<Boolean> = characters[character.code - PRINTABLE.first]

    /** The shapes in [art], each [width] lights wide, row by row: bands of [SIDE] lines, a blank between two shapes. */
    fun glyphs(art: String, width: Int): List<List<Boolean>> =
        art.lines().filter { it.isNotEmpty() }.chunked(SIDE).flatMap { band ->
            List((band[0].length + 1) / (width + 1)) { glyph ->
                List(SIDE * width) { place -> band[place / width][glyph * (width + 1) + place % width] == LIGHT }
            }
        }
}
