package robotran.nxt.display

import robotran.brick.state.Screen
import robotran.brick.state.isSameNumber

/** What the glass of the display shows: 100 by 64 dots. Immutable. */
class NxtDisplay internal constructor(private val bytes: ByteArray) : Screen {
    /** Whether the dot is black; false beyond the edge. */
    fun isBlack(x: Int, y: Int): Boolean = x in 0..<DisplaySize.WIDTH && y in 0..<DisplaySize.HEIGHT &&
        bytes[(y shr ROW_SHIFT) * DisplaySize.WIDTH + x].toInt() shr (y and LAST_BIT) and 1 == 1

    /** Whether no dot is black. */
    val isBlank: Boolean get() = bytes.all { it == NO_DOTS }

    /**
     * The eight rows of characters, without the blanks at their ends. A cell with other dots than those of a character
     * is `?`.
     */
    override val lines: List<String> by lazy { List(DisplaySize.ROWS) { readLine(bytes, it) } }

    override val texts: List<String> get() = lines.map { it.trim() }.filter { it.isNotEmpty() }

    /** Whether a line is [text], apart from blanks around it; a number may be written with more zeros. */
    override fun shows(text: String): Boolean {
        val wanted = text.trim()
        return texts.any { it == wanted || isSameNumber(it, wanted) }
    }

    /** The dots as text, a line for each row of dots: `#` is black, `.` is not. */
    fun toArt(): String = (0..<DisplaySize.HEIGHT).joinToString("") { y ->
        (0..<DisplaySize.WIDTH).joinToString("", postfix = "\n") { x -> if (isBlack(x, y)) "#" else "." }
    }

    internal fun hasBytes(other: ByteArray): Boolean = bytes.contentEquals(other)

    override fun equals(other: Any?): Boolean = other is NxtDisplay && hasBytes(other.bytes)

    override fun hashCode(): Int = bytes.contentHashCode()

    override fun toString(): String = "NxtDisplay(${texts.joinToString(" / ")})"

    companion object {
        private const val ROW_SHIFT = 3
        private const val LAST_BIT = 7
        private const val NO_DOTS: Byte = 0

        /** A glass without black dots. */
        val BLANK = NxtDisplay(ByteArray(DisplaySize.BYTES))

        /** A copy of [memory]. */
        fun of(memory: DisplayMemory): NxtDisplay = NxtDisplay(copyOf(memory))
    }
}

internal fun copyOf(memory: DisplayMemory): ByteArray = ByteArray(DisplaySize.BYTES) { memory[it].toByte() }
