package robotran.json.messages

import robotran.language.Language
import robotran.language.choose
import robotran.language.listed

/**
 * The error messages for JSON files. Most describe what is wrong with a value and follow its path, without a full stop:
 * `must be a number`.
 */
interface JsonMessages : JsonSyntaxMessages {
    /**
     * A whole sentence.
     *
     * @param path such as `walls[2].from`; empty for the whole file.
     * @param reason one of the messages without a full stop.
     */
    fun refused(line: Int, path: String, reason: String): String

    /**
     * What is wrong at a place of the file.
     *
     * @param sentence a whole one of its own.
     */
    fun at(line: Int, path: String, sentence: String): String

    /** A whole sentence, like the next ones. */
    fun fileTooLong(limit: Int): String

    /** The whole [sentence], about a line. */
    fun inLine(line: Int, sentence: String): String

    fun notText(): String

    fun otherEncoding(encoding: String): String

    /** From here on without a full stop. The name of a field is near [known], which nobody has asked for. */
    fun misspelt(known: String): String

    /** An object has a name twice. */
    fun twice(): String

    fun missing(): String

    /** @param written an unknown name near the missing one. */
    fun missingBut(written: String): String

    fun mustBeObject(): String

    fun mustBeList(): String

    fun tooManyEntries(count: Int, limit: Int): String

    fun tooFewEntries(count: Int, min: Int): String

    fun mustBeText(): String

    fun mustNotBeEmpty(): String

    fun tooManyCharacters(limit: Int): String

    fun mustBeOneOrdinaryLine(): String

    fun mustBeOrdinary(): String

    fun mustBeNumber(): String

    fun mustBeFrom(min: String, max: String): String

    fun mustBeWholeFrom(min: Long, max: Long): String

    fun mustBeTrueOrFalse(): String

    fun mustBeOneOf(words: Collection<String>): String

    companion object {
        fun of(language: Language): JsonMessages =
            language.choose(EnglishJsonMessages, SpanishJsonMessages, GermanJsonMessages)
    }
}

/** Such as `"down" or "forward"` with [word] `or`. */
fun alternatives(words: Collection<String>, word: String): String = listed(words.map { "\"$it\"" }, word)

internal fun told(reason: JsonMessages.() -> String): (Language) -> String = { JsonMessages.of(it).reason() }
