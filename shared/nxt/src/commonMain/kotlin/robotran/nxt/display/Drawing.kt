package robotran.nxt.display

/** Texts in the memory of a display, in cells of 6 by 8 dots: columns 0..15 and rows 0..7. */
object Drawing {
    /** The most places of [drawInt]. */
    const val MOST_PLACES = 11

    /** Clears everything. */
    fun clear(memory: DisplayMemory) {
        for (index in 0..<DisplaySize.BYTES) memory[index] = 0
    }

    /**
     * Draws [text] from a cell on, each character with the gap behind it. A line feed goes on in column 0 of the next
     * row. What lies beyond the edge is left out. The cell of a letter that the [font][Font5x7] lacks stays empty.
     *
     * @param inverted whether it is white on black.
     */
    fun drawString(memory: DisplayMemory, text: String, column: Int, row: Int, inverted: Boolean = false) {
        var x = column
        var y = row
        for (character in text) {
            if (character == '\n') {
                x = 0
                y++
            } else {
                drawCell(memory, character, x, y, inverted)
                x++
            }
        }
    }

    /** Draws a number, with blanks before it if it has fewer than [places] characters. */
    fun drawInt(memory: DisplayMemory, number: Int, places: Int, column: Int, row: Int) =
        drawString(memory, intText(number, places), column, row)

    /** What [drawInt] draws. */
    fun intText(number: Int, places: Int): String = number.toString().padStart(places.coerceIn(0, MOST_PLACES))

    private fun drawCell(memory: DisplayMemory, character: Char, column: Int, row: Int, inverted: Boolean) {
        if (column !in 0..<DisplaySize.COLUMNS || row !in 0..<DisplaySize.ROWS) return
        val left = row * DisplaySize.WIDTH + column * DisplaySize.CELL_WIDTH
        val mask = if (inverted) BYTE else 0
        val glyph = Font5x7.glyphOf(character)
        for (dot in 0..<DisplaySize.GLYPH_WIDTH) memory[left + dot] = Font5x7.columnOf(glyph, dot) xor mask
        memory[left + DisplaySize.GLYPH_WIDTH] = mask
    }

    private const val BYTE = 0xFF
}
