package robotran.language

/**
 * The languages of the user interface and its messages. The keywords of Robolang and Java are the same in all of them,
 * and no run depends on the language.
 *
 * @property tag the language tag as in BCP 47 and in the names of resource folders.
 * @property ownName the language's name in the language itself.
 */
enum class Language(val tag: String, val ownName: String) {
    ENGLISH("en", "English"),
    SPANISH("es", "Español"),
    GERMAN("de", "Deutsch"),
    ;

    companion object {
        /**
         * Returns the language of a locale such as `de`, `de-AT`, `es_MX.UTF-8` or `ES`; null if there is none or it is
         * not supported.
         */
        fun of(locale: String): Language? {
            val requestedTag = locale.takeWhile { it.isLetter() }.lowercase()
            return entries.firstOrNull { it.tag == requestedTag }
        }
    }
}

/**
 * Returns the argument for this language. Every module selects its message table with it. A new language is a new
 * parameter here, so the Kotlin compiler reports each module that lacks it.
 */
fun <T> Language.choose(english: T, spanish: T, german: T): T = when (this) {
    Language.ENGLISH -> english
    Language.SPANISH -> spanish
    Language.GERMAN -> german
}
