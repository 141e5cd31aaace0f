package robotran.legofirmware.assembly

/**
 * A word, number or sign of an assembly text.
 *
 * @property text empty if something is missing at this place.
 * @property line from 1.
 * @property column from 1.
 */
internal data class Token(val text: String, val line: Int, val column: Int) {
    val isWord: Boolean get() = text.isNotEmpty() && isWordStart(text[0])

    val isNumber: Boolean get() = text.isNotEmpty() && (text[0].isAsciiDigit || text[0] == '-' || text[0] == '+')

    val isSign: Boolean get() = text == "," || text == ":"

    /** The place after it. */
    val after: Token get() = Token("", line, column + text.length)

    /** The number that it is; null if it is none, or has more than nine digits. */
    val number: Int?
        get() {
            val digits = text.removePrefix("-").removePrefix("+")
            val isHex = digits.startsWith("0x") || digits.startsWith("0X")
            val value = if (isHex) digits.drop(2).toIntOrNull(HEX_RADIX) else digits.toIntOrNull()
            if (value == null || digits.length > LONGEST || digits.any { it == '-' || it == '+' }) return null
            return if (text.startsWith('-')) -value else value
        }

    private companion object {
        const val HEX_RADIX = 16
        const val LONGEST = 9
    }
}

private val Char.isAsciiDigit: Boolean get() = this in '0'..'9'

private fun isWordStart(character: Char): Boolean = character in 'a'..'z' || character in 'A'..'Z' || character == '_'

private fun isWordPart(character: Char): Boolean = isWordStart(character) || character.isAsciiDigit

/** Divides a line into tokens. A comment begins with `;`. A character that belongs to none is a token of its own. */
internal fun tokensOf(text: String, line: Int): List<Token> {
    val tokens = mutableListOf<Token>()
    var position = 0
    while (position < text.length && text[position] != ';') {
        val start = position++
        val first = text[start]
        when {
            first.isWhitespace() || first == BYTE_ORDER_MARK -> continue

            isWordStart(first) || first.isAsciiDigit || first == '-' || first == '+' -> {
                while (position < text.length && isWordPart(text[position])) position++
            }
        }
        tokens += Token(text.substring(start, position), line, start + 1)
    }
    return tokens
}

private const val BYTE_ORDER_MARK = '\uFEFF'
