package robotran.nxt.display

/**
 * The display's only font: 128 characters, 5 dots wide, capital letters 7 dots high, with descenders in the eighth row.
 * As on a real NXT there are no accented letters: the cell of a character from 128 on stays empty. Control characters
 * without a sign of their own are drawn as the box of 127.
 */
object Font5x7 {
    const val CHARACTERS = 128

    /** The characters that have a letter, digit or sign of ASCII. */
    val PRINTABLE = 32..126

    private const val FIRST_PRINTABLE = 32
    private val SIGNS = listOf(1, 2, 3, 4, 5, 6, 8, 13)
    private const val GLYPHS_OF_BAND = 8

    private val columns: ByteArray by lazy {
        val bytes = ByteArray(CHARACTERS * DisplaySize.GLYPH_WIDTH)
        val printable = glyphs(FontArt.PRINTABLE)
        val signs = glyphs(FontArt.SIGNS)
        for (code in 0..<CHARACTERS) {
            val sign = SIGNS.indexOf(code)
            val glyph = when {
                code >= FIRST_PRINTABLE -> printable[code - FIRST_PRINTABLE]
                sign >= 0 -> signs[sign]
                else -> printable.last()
            }
            glyph.copyInto(bytes, code * DisplaySize.GLYPH_WIDTH)
        }
        bytes
    }

    /**
     * The font as a picture of 640 by 8 dots: five bytes a character, each a column with its upper dot in bit 0. A new
     * array.
     */
    fun bytes(): ByteArray = columns.copyOf()

    /** Whether the font has the character itself, not just a box or an empty cell. */
    fun has(character: Char): Boolean = character.code in PRINTABLE || character.code in SIGNS

    /** The number, 0..127, of the glyph for a character; that of the blank for one from 128 on. */
    fun glyphOf(character: Char): Int = if (character.code < CHARACTERS) character.code else FIRST_PRINTABLE

    /** A column, 0..4, of a glyph; bit 0 is its upper dot. */
    fun columnOf(glyph: Int, column: Int): Int = columns[glyph * DisplaySize.GLYPH_WIDTH + column].toInt() and BYTE

    private fun glyphs(art: String): List<ByteArray> =
        art.lines().filter { it.isNotEmpty() }.chunked(DisplaySize.CELL_HEIGHT).flatMap { band ->
            List(GLYPHS_OF_BAND) { glyph ->
                ByteArray(DisplaySize.GLYPH_WIDTH) { column ->
                    val x = glyph * DisplaySize.CELL_WIDTH + column
                    band.indices.sumOf { y -> if (band[y][x] == BLACK) 1 shl y else 0 }.toByte()
                }
            }
        }

    private const val BLACK = '#'
    private const val BYTE = 0xFF
}
