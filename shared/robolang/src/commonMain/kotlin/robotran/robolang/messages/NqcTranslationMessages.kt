package robotran.robolang.messages

import robotran.language.Language
import robotran.language.choose

/** What NQC and LEGO's firmware cannot do like Robolang, one or two sentences each, implemented once per language. */
interface NqcTranslationMessages {
    fun otherBrick(): String

    fun decimal(): String

    fun list(): String

    /** @param number below -32768 or above 32767. */
    fun numberTooLarge(number: Int): String

    fun text(): String

    fun clearScreen(): String

    fun button(): String

    fun whenever(): String

    /** A routine that calls itself, itself or through others. */
    fun recursion(name: String): String

    fun builtIn(name: String): String

    /** A loop whose step is not written as a number. */
    fun unknownStep(): String

    /** A wait or move that takes longer than the brick can wait. */
    fun tooLong(): String

    /** A call on the right of `and` or `or` is made even if the left side decides. */
    fun alwaysCalled(): String

    companion object {
        fun of(language: Language): NqcTranslationMessages = language.choose(
            EnglishNqcTranslationMessages,
            SpanishNqcTranslationMessages,
            GermanNqcTranslationMessages,
        )
    }
}
