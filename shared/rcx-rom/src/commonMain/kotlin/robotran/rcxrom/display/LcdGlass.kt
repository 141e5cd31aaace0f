package robotran.rcxrom.display

import robotran.brick.state.Screen
import robotran.brick.state.isNumber
import robotran.brick.state.isSameNumber
import robotran.rcxrom.memory.RcxMemory

/** The visible content of the LCD: the bytes of its memory as of the last refresh. Immutable. */
class LcdGlass private constructor(private val bytes: List<Int>) : Screen {
    /**
     * The seven segments of one digit.
     *
     * @param position 0 (rightmost, the program digit) to 4 (leftmost, the first of the main number); others are dark.
     * @return a mask: bit 0 middle, 1 top right, 2 top, 3 top left, 4 bottom left, 5 bottom, 6 bottom right (leJOS
     * `TextLCD.java`).
     */
    fun digit(position: Int): Int = LcdLayout.digitSegments.getOrNull(position).orEmpty()
        .foldIndexed(0) { bit, mask, segment -> if (isSet(segment)) mask or (1 shl bit) else mask }

    /** Whether all segments of [icon] are visible. */
    fun isLit(icon: LcdIcon): Boolean = icon.segments.all(::isSet)

    val litIcons: Set<LcdIcon> get() = LcdIcon.entries.filterTo(mutableSetOf(), ::isLit)

    /** The lit icons that are not part of [text]: all but the minus sign and the decimal points. */
    val iconsBesideText: Set<LcdIcon> get() = litIcons - LcdLayout.POINTS.toSet() - LcdIcon.MINUS

    /**
     * The main number in plain text: its four digits with minus sign and decimal point, such as `-42`, `9.0` or `0042`,
     * without surrounding blanks. Letters that seven segments can form are included; `?` stands for any other shape.
     */
    val number: String
        get() = buildString {
            if (isLit(LcdIcon.MINUS)) append('-')
            for (position in LcdLayout.DIGITS - 1 downTo 1) {
                append(LcdGlyphs.read(digit(position)))
                if (position > 1 && isLit(LcdLayout.POINTS[position - 2])) append('.')
            }
        }.trim()

    /** The program digit on the right in plain text, one character or none. */
    val programDigit: String get() = LcdGlyphs.read(digit(0)).toString().trim()

    /**
     * The [number], a blank, and the [programDigit], such as `9.0 0` or `-42 0`. If one of them is dark, only the
     * other; empty on a clear display.
     */
    override val text: String get() = "$number $programDigit".trim()

    /**
     * The five characters from left to right in plain text, without surrounding blanks; letters as seven segments form
     * them.
     */
    val characters: String
        get() = (LcdLayout.DIGITS - 1 downTo 0).map { LcdGlyphs.read(digit(it)) }.joinToString("").trim()

    override val lines: List<String> get() = listOf(text)
    override val texts: List<String> get() = listOf(text, number, characters)

    /**
     * Whether the display shows [text], which a program has shown as a number or as text. `42` matches leJOS's `0042`,
     * `1.5` matches more decimals, and letters match in either case, as far as seven segments can form them. Ignores
     * surrounding blanks, characters after the fifth, and the program digit next to a number.
     */
    override fun shows(text: String): Boolean {
        val wanted = text.trim()
        return isSameNumber(wanted, number) || wanted == this.text || isFormed(wanted)
    }

    /** Whether the display shows the characters of [wanted] from its left edge or, if it is not a number, anywhere. */
    private fun isFormed(wanted: String): Boolean {
        val shown = (LcdLayout.DIGITS - 1 downTo 0).map(::digit).dropLastWhile { it == 0 }
        val begun = if (isNumber(wanted)) shown else shown.dropWhile { it == 0 }
        val characters = wanted.take(TextLcd.CHARACTERS)
        return begun.size == characters.trimEnd().length && begun.zip(characters.toList()).all { (mask, character) ->
            mask == LcdGlyphs.maskOf(character.lowercaseChar()) || mask == LcdGlyphs.maskOf(character.uppercaseChar())
        }
    }

    override fun equals(other: Any?): Boolean = other is LcdGlass && bytes == other.bytes

    override fun hashCode(): Int = bytes.hashCode()

    override fun toString(): String = "LcdGlass($text)"

    private fun isSet(segment: LcdSegment): Boolean =
        bytes[segment.address - LcdLayout.FIRST_ADDRESS] shr segment.bit and 1 == 1

    companion object {
        /** Nothing is visible, as on a brick that is switched off. */
        val BLANK = LcdGlass(List(LcdLayout.SHOWN_BYTES) { 0 })

        /** The content of the glass after a refresh from [memory]. */
        fun of(memory: RcxMemory): LcdGlass =
            LcdGlass(List(LcdLayout.SHOWN_BYTES) { memory.readByte(LcdLayout.FIRST_ADDRESS + it) })
    }
}
