package robotran.language

/** Quotes code or a name for a message in any language. A [text] that contains a quotation mark stays as it is. */
fun quoted(text: String): String = if ('"' in text) text else "\"$text\""

/** Joins [things] as in `A, B and C`, where [word] is `and`. */
fun listed(things: List<String>, word: String): String =
    if (things.size < 2) things.joinToString() else "${things.dropLast(1).joinToString()} $word ${things.last()}"

/** Formats [number] with a sign between thousands. In Spanish, four digits have none. */
fun Language.grouped(number: Int): String {
    val digits = number.toString()
    if (this == Language.SPANISH && digits.length <= UNGROUPED_IN_SPANISH) return digits
    val sign = choose(english = ",", spanish = NO_BREAK_SPACE, german = ".")
    return digits.reversed().chunked(GROUP_DIGITS).joinToString(sign).reversed()
}

/** Formats a measured [number] such as `1.5` with a decimal comma. Not for code, which always has a decimal point. */
fun withComma(number: String): String = number.replace('.', ',')

private const val GROUP_DIGITS = 3
private const val UNGROUPED_IN_SPANISH = 4
private const val NO_BREAK_SPACE = "\u00A0"
