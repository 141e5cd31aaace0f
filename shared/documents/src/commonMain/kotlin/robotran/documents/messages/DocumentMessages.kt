package robotran.documents.messages

import robotran.language.Language
import robotran.language.choose

/**
 * What is said of kept works that cannot be opened, in whole sentences, and what works are called that nobody has given
 * a name.
 */
interface DocumentMessages {
    fun savedByNewer(): String

    /** Each work is kept twice. */
    fun copiesBroken(): String

    /** A name, as the next one. */
    fun defaultProjectName(): String

    fun tutorialProjectName(): String

    companion object {
        fun of(language: Language): DocumentMessages =
            language.choose(EnglishDocumentMessages, SpanishDocumentMessages, GermanDocumentMessages)
    }
}
