package robotran.cli.messages

import robotran.language.Language
import robotran.language.choose

/**
 * The table of what the command line tells a person, one function a message; the words of options and of files that
 * programs read are English.
 */
internal interface CommandMessages :
    FileMessages,
    RunMessages,
    GradeMessages,
    WebMessages {
    companion object {
        fun of(language: Language): CommandMessages =
            language.choose(EnglishCommandMessages, SpanishCommandMessages, GermanCommandMessages)
    }
}

/** What is told of files; a name is always as a person gave it. */
internal interface FileMessages {
    fun noFile(name: String): String

    fun notAllowed(name: String): String

    fun notUtf8(name: String): String

    fun notAJar(name: String): String

    /** @param why what the machine says about it. */
    fun unreadable(name: String, why: String): String

    fun unwritable(name: String, why: String): String

    fun notAFileName(name: String): String

    fun isFolder(name: String): String

    /** It has no end, or may never begin. */
    fun isDevice(name: String): String

    fun fileTooLarge(name: String, bytes: Long): String

    fun noClassFile(name: String): String

    fun tooManyClasses(name: String, limit: Int): String

    fun classFileTooLarge(name: String, bytes: Int): String

    fun jarTooLarge(name: String, bytes: Int): String

    fun tooManyPrograms(limit: Int, given: Int): String

    /** @param endings how the names of programs end. */
    fun notAProgram(name: String, endings: List<String>): String

    /** A link that is the only one. */
    fun theLink(): String

    /** @param name a project file or a link. */
    fun noProgramIn(name: String, robot: String): String

    fun notRobolang(name: String, ending: String): String

    fun notToBeChecked(name: String, endings: List<String>): String

    /** A link was asked for with a program that has no source. */
    fun compiled(name: String): String
}

/** What is told of checking, formatting and running. */
internal interface RunMessages {
    fun noMistakes(name: String): String

    /** @param line the place and the message. */
    fun warning(line: String): String

    fun notFormatted(name: String): String

    /** The window or a picture was asked for, and the command line is there alone. */
    fun needsDesktopApp(): String

    fun projectHasItsOwn(): String

    fun firstRobotNamed(name: String): String

    fun romLogLacks(calls: Long): String

    fun nothingStrayed(): String

    fun ended(seconds: String): String

    fun timeUp(seconds: String): String

    fun failed(seconds: String): String

    /** Centimetres and degrees. */
    fun robotIsAt(x: String, y: String, heading: String, ink: String): String

    fun goalMet(goal: String): String

    fun goalNotMet(goal: String, percent: Int): String
}

/** What is told of grading; not in the files that it writes. */
internal interface GradeMessages {
    fun noGoals(world: String): String

    /** The heads of three columns: what is to be done, with how many seeds it was met, and how far with the worst. */
    fun goalColumns(): List<String>

    /** The heads of three columns: the program, with how many seeds it passed, and the first goal that it missed. */
    fun programColumns(): List<String>

    fun countOf(some: Int, all: Int): String

    fun cannotRun(): String

    fun cannotBeUsed(): String

    /** What one of several links is called. */
    fun numberedLink(number: Int): String

    /** The seeds in words, such as `seeds 1 to 20`. */
    fun seeds(first: Int, last: Int): String

    fun meetsAll(program: String, seeds: String): String

    fun meetsSome(program: String, passed: Int, all: Int, seeds: String): String

    /** @param goal null if it is not known. */
    fun seedMissed(seed: Int, goal: String?, percent: String): String

    fun seedFailed(missed: String, error: String): String

    fun moreSeeds(count: Int, seeds: String): String

    fun runsDone(done: Int, all: Int): String
}
