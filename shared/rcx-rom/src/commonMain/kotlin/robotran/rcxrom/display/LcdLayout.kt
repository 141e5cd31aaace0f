package robotran.rcxrom.display

/** The addresses of the digit segments in the LCD's memory. Sources: leJOS `TextLCD.java`, brickOS `dlcd.h`. */
internal object LcdLayout {
    /** Start of the bytes sent to the display: five bus bytes, then the segments. */
    const val BUS_ADDRESS = 0xEF3E

    /** The first byte of the LCD's memory. */
    const val FIRST_ADDRESS = 0xEF43

    /** Number of bytes the glass shows. */
    const val SHOWN_BYTES = 9

    /** Number of bytes that "clear display" sets to zero. */
    const val CLEARED_BYTES = 10

    /** Digits of the display; 0 is the rightmost (the program digit), 4 the leftmost. */
    const val DIGITS = 5

    /** The decimal points for 1, 2 and 3 decimals of the main number's four digits. */
    val POINTS = listOf(LcdIcon.POINT_1, LcdIcon.POINT_2, LcdIcon.POINT_3)

    /**
     * The segments of each digit, from the right, in the order of the seven mask bits described at [LcdGlass.digit].
     */
    val digitSegments: List<List<LcdSegment>> = listOf(
        digit(
            middleTopBottom = 0xEF44 to listOf(5, 4, 7),
            right = 0xEF45 to listOf(5, 7),
            left = 0xEF47 to listOf(5, 7),
        ),
        digit(
            middleTopBottom = 0xEF43 to listOf(5, 4, 7),
            right = 0xEF47 to listOf(1, 3),
            left = 0xEF48 to listOf(5, 7),
        ),
        digit(
            middleTopBottom = 0xEF44 to listOf(1, 0, 3),
            right = 0xEF48 to listOf(1, 3),
            left = 0xEF49 to listOf(5, 7),
        ),
        digit(
            middleTopBottom = 0xEF46 to listOf(1, 0, 3),
            right = 0xEF4B to listOf(1, 3),
            left = 0xEF4B to listOf(5, 7),
        ),
        digit(
            middleTopBottom = 0xEF46 to listOf(5, 4, 7),
            right = 0xEF4A to listOf(1, 3),
            left = 0xEF4A to listOf(5, 7),
        ),
    )

    /** Each argument is an address and the bits of its segments; the sides have an upper and a lower one. */
    private fun digit(
        middleTopBottom: Pair<Int, List<Int>>,
        right: Pair<Int, List<Int>>,
        left: Pair<Int, List<Int>>,
    ): List<LcdSegment> {
        val (middle, top, bottom) = middleTopBottom.second.map { LcdSegment(middleTopBottom.first, it) }
        val (topRight, bottomRight) = right.second.map { LcdSegment(right.first, it) }
        val (topLeft, bottomLeft) = left.second.map { LcdSegment(left.first, it) }
        return listOf(middle, topRight, top, topLeft, bottomLeft, bottom, bottomRight)
    }

    /** Number of transfer dots shown, 0..5. */
    const val DOTS_STEP = 0xEF4E

    /** Number of circle quarters shown, 0..4. */
    const val CIRCLE_STEP = 0xEF4F
}
