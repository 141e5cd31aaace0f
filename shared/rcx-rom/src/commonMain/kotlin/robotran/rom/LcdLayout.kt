package robotran.rom

/**
 * Where the digits' segments live in the LCD's memory. Sources: leJOS `TextLCD.java`, brickOS `dlcd.h`.
 */
internal object LcdLayout {
    /** The first byte of the LCD's memory. */
    const val FIRST_ADDRESS = 0xEF43

    /** How many bytes the glass shows. */
    const val SHOWN_BYTES = 9

    /** How many bytes "clear display" sets to zero. */
    const val CLEARED_BYTES = 10

    /** Digits of the display; 0 is the rightmost (the program digit), 4 the leftmost. */
    const val DIGITS = 5

    /** The decimals that can be marked by a point: 1, 2 or 3 of the main number's four digits. */
    val POINTS = listOf(LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)

    /** The segments of each digit, from the right, in the order of the seven mask bits described at [LcdGlass.digit]. */
    val digitSegments: List<List<LcdSegment>> = listOf(
        digit(horizontal = 0xEF44, middle = 5, top = 4, bottom = 7, right = 0xEF45, 5, 7, left = 0xEF47, 5, 7),
        digit(horizontal = 0xEF43, middle = 5, top = 4, bottom = 7, right = 0xEF47, 1, 3, left = 0xEF48, 5, 7),
        digit(horizontal = 0xEF44, middle = 1, top = 0, bottom = 3, right = 0xEF48, 1, 3, left = 0xEF49, 5, 7),
        digit(horizontal = 0xEF46, middle = 1, top = 0, bottom = 3, right = 0xEF4B, 1, 3, left = 0xEF4B, 5, 7),
        digit(horizontal = 0xEF46, middle = 5, top = 4, bottom = 7, right = 0xEF4A, 1, 3, left = 0xEF4A, 5, 7),
    )

    private fun digit(
        horizontal: Int, middle: Int, top: Int, bottom: Int,
        right: Int, topRight: Int, bottomRight: Int,
        left: Int, topLeft: Int, bottomLeft: Int,
    ) = listOf(
        LcdSegment(horizontal, middle),
        LcdSegment(right, topRight),
        LcdSegment(horizontal, top),
        LcdSegment(left, topLeft),
        LcdSegment(left, bottomLeft),
        LcdSegment(horizontal, bottom),
        LcdSegment(right, bottomRight),
    )
}
