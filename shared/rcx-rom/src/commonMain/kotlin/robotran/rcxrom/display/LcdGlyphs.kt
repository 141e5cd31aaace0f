package robotran.rcxrom.display

/** The shapes of seven-segment digits, as masks with the bits of [LcdGlass.digit]. Source: leJOS `TextLCD.java`. */
internal object LcdGlyphs {
    /** The masks of the digits 0 to 9. */
    val FIGURES = listOf(0x7E, 0x42, 0x37, 0x67, 0x4B, 0x6D, 0x7D, 0x46, 0x7F, 0x6F)

    /** The middle segment alone. */
    const val MINUS = 0x01

    /** The lowest segment alone. */
    private const val UNDERSCORE = 0x20

    /** Stands for a shape that is no digit or letter. */
    const val UNREADABLE = '?'

    /** The shapes of the characters from space to U+007F, in this order. */
    private val printable = intArrayOf(
        0x00,
        0x42,
        0x0A,
        0x7B,
        0x6D,
        0x13,
        0x7D,
        0x08,
        0x3C,
        0x66,
        0x5B,
        0x43,
        0x10,
        0x01,
        0x10,
        0x13,
        0x7E,
        0x42,
        0x37,
        0x67,
        0x4B,
        0x6D,
        0x7D,
        0x46,
        0x7F,
        0x6F,
        0x21,
        0x21,
        0x31,
        0x21,
        0x61,
        0x17,
        0x3F,
        0x5F,
        0x79,
        0x3C,
        0x73,
        0x3D,
        0x1D,
        0x7C,
        0x5B,
        0x42,
        0x62,
        0x5B,
        0x38,
        0x5E,
        0x5E,
        0x7E,
        0x1F,
        0x4F,
        0x11,
        0x6D,
        0x46,
        0x7A,
        0x7A,
        0x7A,
        0x5B,
        0x6B,
        0x37,
        0x3C,
        0x49,
        0x66,
        0x0E,
        0x20,
        0x02,
        0x5F,
        0x79,
        0x31,
        0x73,
        0x3D,
        0x1D,
        0x7C,
        0x59,
        0x42,
        0x62,
        0x5B,
        0x38,
        0x51,
        0x51,
        0x71,
        0x1F,
        0x4F,
        0x11,
        0x6D,
        0x39,
        0x70,
        0x70,
        0x70,
        0x5B,
        0x6B,
        0x37,
        0x3C,
        0x18,
        0x66,
        0x0E,
        0x00,
    )

    private val characters: Map<Int, Char> = buildMap {
        put(0x00, ' ')
        put(MINUS, '-')
        put(UNDERSCORE, '_')
        put(0x5F, 'A')
        put(0x79, 'b')
        put(0x3C, 'C')
        put(0x31, 'c')
        put(0x73, 'd')
        put(0x3D, 'E')
        put(0x1D, 'F')
        put(0x5B, 'H')
        put(0x59, 'h')
        put(0x62, 'J')
        put(0x38, 'L')
        put(0x51, 'n')
        put(0x71, 'o')
        put(0x1F, 'P')
        put(0x11, 'r')
        put(0x39, 't')
        put(0x7A, 'U')
        put(0x70, 'u')
        put(0x6B, 'y')
        FIGURES.forEachIndexed { figure, mask -> put(mask, '0' + figure) }
    }

    /** The character that the segments of [mask] form. */
    fun read(mask: Int): Char = characters[mask] ?: UNREADABLE

    /**
     * The shape closest to [character]. Control characters and characters beyond ASCII, which josx cannot print, become
     * an underscore.
     */
    fun maskOf(character: Char): Int = when {
        character.code == 0 -> 0
        character < ' ' -> UNDERSCORE
        else -> printable.getOrElse(character - ' ') { UNDERSCORE }
    }
}
