package robotran.language

/** [text] between quotation marks, unless it is or has one itself: for code and names, in all languages alike. */
fun quoted(text: String): String = if ('"' in text) text else "\"$text\""

/** Such as `A, B and C` with [word] `and`. */
fun listed(things: List<String>, word: String): String =
    if (things.size < 2) things.joinToString() else "${things.dropLast(1).joinToString()} $word ${things.last()}"

/**
 * A measured [number] such as `1.5`, to be read by people who write `1,5`. Not for code, which has a point everywhere.
 */
fun withComma(number: String): String = number.replace('.', ',')
