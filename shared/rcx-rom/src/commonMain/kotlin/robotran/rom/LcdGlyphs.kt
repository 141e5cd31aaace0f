package robotran.rom

/** The shapes of seven-segment digits, as masks with the bits of [LcdGlass.digit]. Source: leJOS `TextLCD.java`. */
internal object LcdGlyphs {
    /** The masks of the figures 0 to 9. */
    val FIGURES = listOf(0x7E, 0x42, 0x37, 0x67, 0x4B, 0x6D, 0x7D, 0x46, 0x7F, 0x6F)

    /** The middle segment alone. */
    const val MINUS = 0x01

    /** What stands for a shape that is no figure or letter. */
    const val UNREADABLE = '?'

    private val characters: Map<Int, Char> = buildMap {
        put(0x00, ' ')
        put(MINUS, '-')
        put(0x20, '_')
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

    /** What a reader takes the segments of [mask] for. */
    fun read(mask: Int): Char = characters[mask] ?: UNREADABLE
}
