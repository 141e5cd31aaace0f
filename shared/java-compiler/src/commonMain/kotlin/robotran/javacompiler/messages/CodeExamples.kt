package robotran.javacompiler.messages

/** The bracket that [bracket] closes. */
internal fun openingOf(bracket: String) = when (bracket) {
    ")" -> "("
    "]" -> "["
    else -> "{"
}

/** A condition behind [word], which is code in all languages. */
internal fun exampleOf(word: String) = when (word) {
    "for" -> "for (int i = 0; i < 4; i++)"
    else -> "$word (light < 40)"
}
