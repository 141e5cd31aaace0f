package robotran.assignments.messages

import robotran.language.Language
import robotran.language.choose

/** Why a submission cannot be used, and what a teacher should know about one. Each `file` is its name. */
interface CollectingMessages {
    fun notText(file: String): String

    fun tooLarge(file: String, bytes: Int): String

    /** A program is too long to be opened. */
    fun programTooLong(file: String, characters: Int): String

    fun brokenZip(file: String): String

    fun zip64(file: String): String

    fun encrypted(file: String): String

    fun unknownCompression(file: String): String

    /** @param depth the number of zips inside each other that can be read. */
    fun zipTooDeep(file: String, depth: Int): String

    fun zipTooLarge(file: String, bytes: Int): String

    fun tooManyEntries(file: String, limit: Int): String

    /** Nothing in it is a program, a project or a link. */
    fun nothingUsable(): String

    /** A project or link without programs for its first robot. */
    fun noProgram(robot: String): String

    /** A link to a world. */
    fun onlyWorld(): String

    /** A link to a course. */
    fun onlyCourse(): String

    fun tooManyPrograms(count: Int, limit: Int): String

    /** The name of several submissions that were left out. */
    fun others(): String

    fun leftOut(count: Int, limit: Int): String

    /** The name of the link in a line. */
    fun linkIn(file: String, line: Int): String

    /** The file is the assignment, as it was given. */
    fun isAssignment(file: String): String

    /** The file is a teacher's answer to a hand-in. */
    fun isFeedback(file: String): String

    /** The name of a link that was pasted or scanned; they are numbered from 1. */
    fun pastedLink(number: Int): String

    /** The file is not as it was handed in. From here on, the functions are remarks on a submission that is usable. */
    fun changed(): String

    fun otherAssignment(title: String): String

    fun worldChanged(): String

    /** The assignment allows to change the world. */
    fun ownWorld(): String

    /** The programs are those that the pupil began with. */
    fun unchanged(): String

    /** @param count of hand-ins with the same name. */
    fun sameName(count: Int, file: String): String

    fun languageNotAllowed(program: String): String

    fun wordsNotAllowed(words: List<String>): String

    /** The same pupil has handed in [count] more. */
    fun olderLeftOut(count: Int): String

    companion object {
        fun of(language: Language): CollectingMessages =
            language.choose(EnglishCollectingMessages, SpanishCollectingMessages, GermanCollectingMessages)
    }
}
