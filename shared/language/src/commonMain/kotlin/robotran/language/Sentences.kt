package robotran.language

/** Quotes code or a name for a message in any language. A [text] that contains a quotation mark stays as it is. */
fun quoted(text: String): String = if ('"' in text) text else "\"$text\""

/** Joins [things] as in `A, B and C`, where [word] is `and`. */
fun listed(things: List<String>, word: String): String =
    if (things.size < 2) things.joinToString() else "${things.dropLast(1).joinToString()} $word ${things.last()}"

/** Formats a measured [number] such as `1.5` with a decimal comma. Not for code, which always has a decimal point. */
fun withComma(number: String): String = number.replace('.', ',')
