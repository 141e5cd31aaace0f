package robotran.brick.messages

import robotran.language.Language
import robotran.language.choose

/** The words for a location in a program, in one language. */
interface PlaceMessages {
    /**
     * A location in a program, at the beginning of a sentence: `Line 7`.
     *
     * @param line from 1.
     * @param file null if the program has only one.
     */
    fun place(line: Int, file: String?): String

    companion object {
        fun of(language: Language): PlaceMessages =
            language.choose(EnglishPlaceMessages, SpanishPlaceMessages, GermanPlaceMessages)
    }
}
