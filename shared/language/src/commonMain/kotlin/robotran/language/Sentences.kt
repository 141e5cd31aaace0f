package robotran.language

/** Quotes code or a name for a message in any language. A [text] that contains a quotation mark stays as it is. */
fun quoted(text: String): String = if ('"' in text) text else "\"$text\""

/** Joins [things] as in `A, B and C`, where [word] is `and`. */
fun listed(things: List<Any>, word: String): String =
    if (things.size < 2) things.joinToString() else "${things.dropLast(1).joinToString()} $word ${things.last()}"

/** Formats [number] with a sign between thousands. In Spanish, four digits have none. */
fun Language.grouped(number: Int): String {
    val digits = number.toString()
    if (digits.length <= ungroupedDigits) return digits
    return digits.reversed().chunked(GROUP_DIGITS).joinToString(groupSign).reversed()
}

/** Formats a measured [number] such as `1.5` with the decimal sign of the language. Code always has a decimal point. */
fun Language.decimal(number: String): String = number.replace('.', decimalSign)

private const val GROUP_DIGITS = 3
