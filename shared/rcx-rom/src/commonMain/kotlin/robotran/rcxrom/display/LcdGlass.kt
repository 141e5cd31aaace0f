package robotran.rcxrom.display

import robotran.rcxrom.memory.RcxMemory

/** What the LCD shows: the bytes of its memory as they were at the last refresh. Never changes. */
class LcdGlass private constructor(private val bytes: List<Int>) {
    /**
     * The seven segments of one digit.
     *
     * @param position 0 (rightmost, the program digit) to 4 (leftmost, the first of the main number); others are dark.
     * @return a mask: bit 0 middle, 1 top right, 2 top, 3 top left, 4 bottom left, 5 bottom, 6 bottom right (leJOS
     * `TextLCD.java`).
     */
    fun digit(position: Int): Int = LcdLayout.digitSegments.getOrNull(position).orEmpty()
        .foldIndexed(0) { bit, mask, segment -> if (isSet(segment)) mask or (1 shl bit) else mask }

    /** Whether the whole of [icon] is dark on the glass. */
    fun isLit(icon: LcdIcon): Boolean = icon.segments.all(::isSet)

    /** The icons that are lit. */
    val litIcons: Set<LcdIcon> get() = LcdIcon.entries.filterTo(mutableSetOf(), ::isLit)

    /** The icons that are lit and are no part of the [text], as its minus sign and its points are. */
    val iconsBesideText: Set<LcdIcon> get() = litIcons - LcdLayout.POINTS.toSet() - LcdIcon.MINUS

    /**
     * The main number as a reader would read it: its four digits with their minus sign and decimal point, such as
     * `-42`, `9.0` or `0042`, without the blanks around them; letters that seven segments can form are read too, `?`
     * stands for any other shape.
     */
    val number: String
        get() = buildString {
            if (isLit(LcdIcon.MINUS)) append('-')
            for (position in LcdLayout.DIGITS - 1 downTo 1) {
                append(LcdGlyphs.read(digit(position)))
                if (position > 1 && isLit(LcdLayout.POINTS[position - 2])) append('.')
            }
        }.trim()

    /** The program digit on the right as a reader would read it, one character or none. */
    val programDigit: String get() = LcdGlyphs.read(digit(0)).toString().trim()

    /**
     * The [number], a blank, and the [programDigit], such as `9.0 0` or `-42 0`; only the one that shows anything if
     * the other is dark, and empty on a clear display.
     */
    val text: String get() = "$number $programDigit".trim()

    /**
     * The five characters from left to right as a reader would read a text, without blanks around it; letters as seven
     * segments form them.
     */
    val characters: String
        get() = (LcdLayout.DIGITS - 1 downTo 0).map { LcdGlyphs.read(digit(it)) }.joinToString("").trim()

    /**
     * Whether a reader would say that the display shows [text], which a program has shown as a number or as a text:
     * `42` also where leJOS writes `0042`, `1.5` also where there are more decimals, letters small or large as seven
     * segments can form them. Blanks around the text do not count, nor what is beyond five characters. The program
     * digit beside a number is no part of it.
     */
    fun shows(text: String): Boolean {
        val wanted = text.trim()
        return isSameNumber(wanted, number) || wanted == this.text || isFormed(wanted)
    }

    /**
     * Whether the characters of [wanted] stand on the display from its left edge on or, if it is no number, anywhere.
     */
    private fun isFormed(wanted: String): Boolean {
        val shown = (LcdLayout.DIGITS - 1 downTo 0).map(::digit).dropLastWhile { it == 0 }
        val begun = if (wanted.matches(NUMBER)) shown else shown.dropWhile { it == 0 }
        val characters = wanted.take(TextLcd.CHARACTERS)
        return begun.size == characters.trimEnd().length && begun.zip(characters.toList()).all { (mask, character) ->
            mask == LcdGlyphs.maskOf(character.lowercaseChar()) || mask == LcdGlyphs.maskOf(character.uppercaseChar())
        }
    }

    /** Whether both are numbers and the same one, however many zeros they are written with. */
    private fun isSameNumber(one: String, other: String): Boolean =
        one.matches(NUMBER) && other.matches(NUMBER) && withoutIdleZeros(one) == withoutIdleZeros(other)

    private fun withoutIdleZeros(number: String): String {
        val minus = if (number.startsWith('-')) "-" else ""
        val whole = number.removePrefix("-").substringBefore('.').trimStart('0').ifEmpty { "0" }
        val decimals = number.substringAfter('.', "").trimEnd('0')
        return minus + whole + if (decimals.isEmpty()) "" else ".$decimals"
    }

    override fun equals(other: Any?): Boolean = other is LcdGlass && bytes == other.bytes

    override fun hashCode(): Int = bytes.hashCode()

    override fun toString(): String = "LcdGlass($text)"

    private fun isSet(segment: LcdSegment): Boolean =
        bytes[segment.address - LcdLayout.FIRST_ADDRESS] shr segment.bit and 1 == 1

    companion object {
        private val NUMBER = Regex("-?[0-9]+(\\.[0-9]+)?")

        /** Nothing is shown, as on a brick that is switched off. */
        val BLANK = LcdGlass(List(LcdLayout.SHOWN_BYTES) { 0 })

        /** What the glass shows when it is refreshed from [memory]. */
        fun of(memory: RcxMemory): LcdGlass =
            LcdGlass(List(LcdLayout.SHOWN_BYTES) { memory.readByte(LcdLayout.FIRST_ADDRESS + it) })
    }
}
