package robotran.language

/**
 * The languages that Robotran speaks with a pupil. The words of Robolang and Java are the same in all of them, and
 * nothing about a run depends on it.
 *
 * @property tag as in BCP 47 and in the names of resource folders.
 * @property ownName what its speakers call it.
 */
enum class Language(val tag: String, val ownName: String) {
    ENGLISH("en", "English"),
    SPANISH("es", "Español"),
    GERMAN("de", "Deutsch"),
    ;

    companion object {
        /**
         * The language that a locale such as `de`, `de-AT`, `es_MX.UTF-8` or `ES` asks for; null if there is none, or
         * another one.
         */
        fun of(locale: String): Language? {
            val asked = locale.takeWhile { it.isLetter() }.lowercase()
            return entries.firstOrNull { it.tag == asked }
        }
    }
}

/**
 * The one of these that is said in this language. Every module chooses its table of messages by it, so a new language
 * is a new parameter here, and the compiler names each module that does not speak it yet.
 */
fun <T> Language.choose(english: T, spanish: T, german: T): T = when (this) {
    Language.ENGLISH -> english
    Language.SPANISH -> spanish
    Language.GERMAN -> german
}
