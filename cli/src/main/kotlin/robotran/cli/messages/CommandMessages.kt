package robotran.cli.messages

import robotran.language.Language
import robotran.language.choose

/** All messages of the command line, one function per message. Option names and machine-readable files stay English. */
internal interface CommandMessages :
    FileMessages,
    RunMessages,
    RobotMessages,
    GradeMessages,
    TowerMessages,
    WebMessages,
    OutputMessages {
    companion object {
        fun of(language: Language): CommandMessages =
            language.choose(EnglishCommandMessages, SpanishCommandMessages, GermanCommandMessages)
    }
}

/** Messages about files. Each `name` is as the user entered it. */
internal interface FileMessages {
    /** The language of these messages. */
    val language: Language

    fun noFile(name: String): String

    fun notAllowed(name: String): String

    fun notText(name: String): String

    fun notAJar(name: String): String

    /** @param why the error message of the operating system. */
    fun unreadable(name: String, why: String): String

    fun isFolder(name: String): String

    /** The file is a device or pipe, which may block or never end. */
    fun isDevice(name: String): String

    fun fileTooLarge(name: String, bytes: Long): String

    fun noClassFile(name: String): String

    /** The folder [name] has sources and what was compiled of them. */
    fun sourceCounts(name: String): String

    fun tooManyClasses(name: String, limit: Int): String

    fun classFileTooLarge(name: String, bytes: Int): String

    fun jarTooLarge(name: String, bytes: Int): String

    fun tooManyPrograms(limit: Int, given: Int): String

    /** @param endings the file extensions of programs. */
    fun notAProgram(name: String, endings: List<String>): String

    /** A program in NQC, in [line] of the file [name], includes a file that it may not. */
    fun includesOutside(name: String, line: Int, included: String): String

    /** A symbolic link in a folder leads out of it. */
    fun leadsOutside(name: String): String

    /** The name of the link if there is only one. */
    fun theLink(): String

    /** @param name a project file or a link. */
    fun noProgramIn(name: String, robot: String): String

    fun notRobolang(name: String, ending: String): String

    fun notToBeChecked(name: String, endings: List<String>): String

    /** A link was requested for a program without source code. */
    fun compiled(name: String): String
}

/** Messages about checking, formatting and running. */
internal interface RunMessages {
    fun noMistakes(name: String): String

    /** @param line the position and the message. */
    fun warning(line: String): String

    /** A program runs here, but not on a real brick. [reason] is a sentence. */
    fun refusedByBrick(reason: String): String

    /** The image [name] was written; null if none was asked for. Both numbers are bytes. */
    fun imageBuilt(name: String?, bytes: String, left: String): String

    /** The image [name] for LEGO's own firmware was written; null if none was asked for. Both numbers are bytes. */
    fun firmwareImageBuilt(name: String?, bytes: String, limit: String): String

    fun notFormatted(name: String): String

    fun notInUtf8(name: String, encoding: String): String

    /** It was formatted. */
    fun nowInUtf8(name: String, encoding: String): String

    /** The window or a picture was requested, but the desktop app is not included. */
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

    /** When and where something happened. The functions below are its parts, each without a full stop. */
    fun atTime(seconds: String): String

    /** In centimetres. */
    fun atPlace(x: String, y: String): String

    fun atLine(line: Int): String

    fun atLineOf(file: String, line: Int): String
}

/** Console messages about grading. Report files do not use them. */
internal interface GradeMessages {
    fun noGoals(world: String): String

    /** Nothing was found to grade. */
    fun noHandIns(): String

    /** The page about a class was requested, but the desktop app is not included. */
    fun pageWithoutPictures(): String

    /** A program was given to a robot that is not there. */
    fun noRobot(name: String): String

    /** The column headings: goal, number of seeds that met it, lowest progress. */
    fun goalColumns(): List<String>

    /** The column headings: program, number of seeds passed, first goal missed. */
    fun programColumns(): List<String>

    fun countOf(some: Int, all: Int): String

    fun cannotRun(): String

    fun cannotBeUsed(): String

    /** The name of a link if there are several. */
    fun numberedLink(number: Int): String

    /** A seed range in words, such as `seeds 1 to 20`. */
    fun seeds(first: Int, last: Int): String

    fun meetsAll(program: String, seeds: String): String

    fun meetsSome(program: String, passed: Int, all: Int, seeds: String): String

    /** @param goal null if unknown. */
    fun seedMissed(seed: Int, goal: String?, percent: String): String

    fun seedFailed(missed: String, error: String): String

    /** In place of the first goal that was missed, in a world without goals. */
    fun noGoal(): String

    fun programFailed(error: String): String

    fun moreSeeds(count: Int, seeds: String): String

    fun runsDone(done: Int, all: Int): String
}
