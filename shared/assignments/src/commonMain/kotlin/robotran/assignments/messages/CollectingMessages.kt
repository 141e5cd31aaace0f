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

    /** It is not graded, since it was made for the assignment called [title]. */
    fun otherAssignment(title: String): String

    /** In a course: neither it nor its folder says which assignment it is for. */
    fun noTask(): String

    /** A folder has no file in it. */
    fun emptyFolder(): String

    /** There are class files, and not the Java that they were made of. */
    fun onlyCompiled(): String

    /** The file is not as it was handed in. From here on, the functions are remarks on a submission that is usable. */
    fun changed(): String

    fun worldChanged(): String

    /** The assignment allows to change the world. */
    fun ownWorld(): String

    /** The programs are those that the pupil began with. */
    fun unchanged(): String

    /** @param count of hand-ins with the same name. */
    fun sameName(count: Int, file: String): String

    fun languageNotAllowed(program: String): String

    fun wordsNotAllowed(words: List<String>): String

    /** It is the teacher's own file. */
    fun teachersFile(): String

    /** A program equals the teacher's solution. */
    fun isSolution(): String

    /** @param entered what the hand-in says; the pupil's folder says something else. */
    fun otherName(entered: String): String

    /** Of [all], which were graded, [chosen] did best. */
    fun bestCounts(chosen: String, all: List<String>): String

    /** Of the programs [all], [chosen] was chosen in the app. */
    fun chosenInApp(chosen: String, all: List<String>): String

    /** @param programs files that lie beside a project. */
    fun besideProject(programs: List<String>): String

    /** @param origins of hand-ins of the same pupil. */
    fun fewerTries(origins: List<String>): String

    /** @param origins of hand-ins of the same pupil that are too many to be tried. */
    fun notTried(origins: List<String>): String

    /** @param reason a sentence. */
    fun partUnusable(reason: String): String

    /** @param classes files with compiled classes. */
    fun compiledLeftOut(classes: List<String>): String

    companion object {
        fun of(language: Language): CollectingMessages =
            language.choose(EnglishCollectingMessages, SpanishCollectingMessages, GermanCollectingMessages)
    }
}
