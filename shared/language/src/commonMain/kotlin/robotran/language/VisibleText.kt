package robotran.language

/**
 * [text] with each character that would act instead of being seen as an escape such as `\u001b`: control characters,
 * which a terminal obeys, and those that turn the direction of what follows, which hide what a line says. Line ends and
 * tabs stay.
 */
fun visibleText(text: String): String {
    if (text.indices.none { isHidden(text, it) }) return text
    return buildString {
        for (index in text.indices) {
            if (isHidden(text, index)) append(escaped(text[index])) else append(text[index])
        }
    }
}

/** The same in one line. */
fun visibleLine(text: String): String =
    visibleText(text).map { if (it in LINE_ENDS || it == '\t') escaped(it) else "$it" }.joinToString("")

private fun isHidden(text: String, index: Int): Boolean {
    val letter = text[index]
    return when {
        letter == '\n' || letter == '\t' -> false
        letter == '\r' -> text.getOrNull(index + 1) != '\n'
        letter.isISOControl() || letter in DIRECTIONS -> true
        letter.isHighSurrogate() -> text.getOrNull(index + 1)?.isLowSurrogate() != true
        letter.isLowSurrogate() -> text.getOrNull(index - 1)?.isHighSurrogate() != true
        else -> false
    }
}

private fun escaped(letter: Char): String = "\\u" + letter.code.toString(HEX).padStart(DIGITS, '0')

/** Line and paragraph separators, embeddings, overrides and isolates of Unicode. */
private const val DIRECTIONS = "\u2028\u2029\u202A\u202B\u202C\u202D\u202E\u2066\u2067\u2068\u2069"
private const val LINE_ENDS = "\r\n"
private const val HEX = 16
private const val DIGITS = 4
