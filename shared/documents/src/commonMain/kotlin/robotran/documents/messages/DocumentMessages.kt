package robotran.documents.messages

import robotran.language.Language
import robotran.language.choose

/**
 * What is said of kept works that cannot be opened and of files that were read although they are unusual, in whole
 * sentences, and what works are called that nobody has given a name.
 */
interface DocumentMessages {
    fun savedByNewer(): String

    /** Each work is kept twice. */
    fun copiesBroken(): String

    /** A name, as the next one. */
    fun defaultProjectName(): String

    fun tutorialProjectName(): String

    /** A text is not in UTF-8. A whole sentence, as the next one. */
    fun decodedFrom(file: String, encoding: String): String

    /** A program has another name than its kind usually has. */
    fun readAs(file: String, name: String): String

    companion object {
        fun of(language: Language): DocumentMessages =
            language.choose(EnglishDocumentMessages, SpanishDocumentMessages, GermanDocumentMessages)
    }
}
