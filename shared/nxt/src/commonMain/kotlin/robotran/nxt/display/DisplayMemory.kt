package robotran.nxt.display

/**
 * The bytes of a picture, wherever they are. Rows of eight dots follow one another: dot x, y is bit y % 8 of the byte
 * at y / 8 * width + x. A set bit is a black dot.
 */
interface DisplayMemory {
    /** The byte at [index], 0..255. */
    operator fun get(index: Int): Int

    /** Stores the low eight bits of [byte]. */
    operator fun set(index: Int, byte: Int)
}

/** A picture in an array. */
class ByteArrayMemory(val bytes: ByteArray) : DisplayMemory {
    override fun get(index: Int): Int = bytes[index].toInt() and BYTE

    override fun set(index: Int, byte: Int) {
        bytes[index] = byte.toByte()
    }

    private companion object {
        const val BYTE = 0xFF
    }
}

/** Sizes of the display, in dots unless they say otherwise. */
object DisplaySize {
    const val WIDTH = 100
    const val HEIGHT = 64

    /** Bytes of the display's memory. */
    const val BYTES = 800

    /** Characters of a row. Four dots to the right of the last one are free. */
    const val COLUMNS = 16

    /** Rows of characters. */
    const val ROWS = 8

    const val GLYPH_WIDTH = 5

    /** A character with the gap behind it. */
    const val CELL_WIDTH = 6
    const val CELL_HEIGHT = 8
}
