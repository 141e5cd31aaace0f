package robotran.javacompiler.messages

/** The opening bracket for the closing [bracket]. */
internal fun openingOf(bracket: String) = when (bracket) {
    ")" -> "("
    "]" -> "["
    else -> "{"
}

/** An example of a condition after [word]. It is code, so it is the same in all languages. */
internal fun exampleOf(word: String) = when (word) {
    "for" -> "for (int i = 0; i < 4; i++)"
    else -> "$word (light < 40)"
}
