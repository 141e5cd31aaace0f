package robotran.projects.messages

import robotran.language.Language
import robotran.language.choose

/** What is said of projects, links and the programs of robots that cannot be used. */
interface ProjectMessages :
    ProjectFileMessages,
    LinkMessages,
    RobotMessages {
    companion object {
        fun of(language: Language): ProjectMessages =
            language.choose(EnglishProjectMessages, SpanishProjectMessages, GermanProjectMessages)
    }
}

/**
 * What is said of project files, beyond what is said of the world in them. Most is what is wrong with a value, and is
 * read behind its path, without a full stop.
 */
interface ProjectFileMessages {
    /** A whole sentence. */
    fun notAProject(format: String): String

    /** A whole sentence. */
    fun newerProject(version: Int, known: Int): String

    /** From here on without a full stop. */
    fun robotTwice(name: String): String

    fun mustNameRobotOfWorld(): String

    fun mustNotHave(field: String): String

    fun mustBeOneLine(): String

    fun beforeInputAbove(): String

    /** A lamp was moved in a world that has none. */
    fun noLamp(): String

    /** A block was moved in a world that has none. */
    fun noBlock(): String
}

/** What is said of links, in whole sentences. */
interface LinkMessages {
    fun notALink(): String

    fun linkTooLong(limit: Int): String

    fun newerLink(): String

    fun linkBroken(): String

    /** @param why a sentence about the file that is in the link. */
    fun linkUnusable(why: String): String

    fun worldTooLong(characters: Int, limit: Int): String

    fun projectTooLong(characters: Int, limit: Int): String
}

/** What is said of giving programs to robots, in whole sentences. */
interface RobotMessages {
    /** @param robots the names of those that there are, never empty. */
    fun unknownRobot(name: String, robots: List<String>): String

    fun tooManyPrograms(robot: String, count: Int, limit: Int): String
}

internal fun told(reason: ProjectMessages.() -> String): (Language) -> String = { ProjectMessages.of(it).reason() }
