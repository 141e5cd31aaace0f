package robotran.nxt.display

/** The characters of a row, 0..7, found by comparing its cells with the font; without the blanks at its end. */
internal fun readLine(bytes: ByteArray, row: Int): String = buildString {
    for (column in 0..<DisplaySize.COLUMNS) {
        append(characterOf(bytes, row * DisplaySize.WIDTH + column * DisplaySize.CELL_WIDTH))
    }
}.trimEnd()

/** The character of the cell that begins at [left], black on white or white on black; `?` if it is none. */
private fun characterOf(bytes: ByteArray, left: Int): Char {
    val isInverted = bytes[left + DisplaySize.GLYPH_WIDTH] == FULL
    val mask = if (isInverted) BYTE else 0L
    var dots = 0L
    for (dot in 0..<DisplaySize.GLYPH_WIDTH) {
        dots = (dots shl BYTE_BITS) or ((bytes[left + dot].toLong() and BYTE) xor mask)
    }
    return CHARACTERS[dots] ?: UNKNOWN
}

/**
 * By the dots of a glyph, its columns from left to right. Of two characters that look the same, the blank or letter.
 */
private val CHARACTERS: Map<Long, Char> by lazy {
    buildMap {
        for (code in Font5x7.PRINTABLE) {
            var dots = 0L
            for (dot in 0..<DisplaySize.GLYPH_WIDTH) dots = (dots shl BYTE_BITS) or Font5x7.columnOf(code, dot).toLong()
            if (dots !in this) put(dots, code.toChar())
        }
    }
}

private const val UNKNOWN = '?'
private const val FULL: Byte = -1
private const val BYTE = 0xFFL
private const val BYTE_BITS = 8
