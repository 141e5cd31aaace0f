package robotran.nqc.syntax

internal fun isNameStart(character: Char): Boolean = character in 'a'..'z' || character in 'A'..'Z' || character == '_'

internal fun isNamePart(character: Char): Boolean = isNameStart(character) || isDigit(character)

internal fun isDigit(character: Char): Boolean = character in '0'..'9'

internal fun isHexDigit(character: Char): Boolean = isDigit(character) || character in 'a'..'f' || character in 'A'..'F'

/** Blanks; the last one ends files of DOS. */
internal fun isBlank(character: Char): Boolean = character == ' ' || character == '\t' || character == '\u001A'

internal fun isLineEnd(character: Char): Boolean = character == '\n' || character == '\r'

/** The index after the number at [start]; the number begins with a digit. */
internal fun endOfNumber(text: String, start: Int): Int {
    val isHex = text[start] == '0' && start + 2 < text.length && text[start + 1] in "xX" && isHexDigit(text[start + 2])
    var end = if (isHex) start + 2 else start
    while (end < text.length && (if (isHex) isHexDigit(text[end]) else isDigit(text[end]))) end++
    return end
}

/** The value of a number as typed; null if it has more than 32 bits. Only decimal ones have a sign. */
internal fun numberOf(text: String): Int? = if (text.length > 2 && text[1] in "xX") {
    text.substring(2).toUIntOrNull(radix = 16)?.toInt()
} else {
    text.toIntOrNull()
}
