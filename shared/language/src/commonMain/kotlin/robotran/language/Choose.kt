package robotran.language

/**
 * Returns the argument for this language. Every module selects its message table with it. A new language is a new
 * parameter here, so the Kotlin compiler reports each module that lacks it.
 */
fun <T> Language.choose(english: T, spanish: T, german: T): T = when (this) {
    Language.ENGLISH -> english
    Language.SPANISH -> spanish
    Language.GERMAN -> german
}
