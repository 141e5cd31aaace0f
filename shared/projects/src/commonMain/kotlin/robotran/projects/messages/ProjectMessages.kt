package robotran.projects.messages

import robotran.language.Language
import robotran.language.choose

/** The error messages for projects, links and the programs of robots. */
interface ProjectMessages :
    ProjectFileMessages,
    CourseFileMessages,
    LinkMessages,
    RobotMessages {
    companion object {
        fun of(language: Language): ProjectMessages =
            language.choose(EnglishProjectMessages, SpanishProjectMessages, GermanProjectMessages)
    }
}

/**
 * The error messages for project files, in addition to those for worlds. Most describe what is wrong with a value and
 * follow its path, without a full stop.
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

    /** The content of a file must be written in Base64. */
    fun mustBeBytes(): String

    /** A brick cannot keep the files: their names, number or sizes are beyond its limits. */
    fun mustFitIntoFlash(): String

    /** The data of a picture are damaged. */
    fun mustBeBase64(): String

    fun tooManySeeds(limit: Int): String

    /** @param characters of all lines together. */
    fun mustNotBeLongerThan(characters: Int): String

    /** An input moves a lamp in a world without lamps. */
    fun noLamp(): String

    /** An input moves a block in a world without blocks. */
    fun noBlock(): String
}

/** The error messages for course files, in addition to those for projects. */
interface CourseFileMessages {
    /** A whole sentence. */
    fun notACourse(format: String): String

    /** A whole sentence. */
    fun newerCourse(version: Int, known: Int): String

    /** From here on without a full stop. A project of the course is not an assignment. */
    fun mustBeAssignment(): String

    /** @param id of two assignments. */
    fun assignmentTwice(id: String): String

    /** A name leads to another folder. */
    fun mustBeFileName(): String

    /** The course names a file that was not opened together with it. */
    fun fileNotBeside(name: String): String
}

/** The error messages for links, in whole sentences. */
interface LinkMessages {
    fun notALink(): String

    /** The link holds a hand-in without its world. */
    fun handInLink(): String

    /** @param limit a number as it is to be shown, here and below. */
    fun linkTooLong(limit: String): String

    fun newerLink(): String

    fun linkBroken(): String

    /** @param why a sentence about the file in the link. */
    fun linkUnusable(why: String): String

    fun worldTooLong(characters: String, limit: String): String

    fun projectTooLong(characters: String, limit: String): String

    /** Without its pictures it would not be. */
    fun projectPicturesTooLong(characters: String, limit: String): String

    fun courseTooLong(characters: String, limit: String): String

    /** Without its pictures it would not be. */
    fun coursePicturesTooLong(characters: String, limit: String): String
}

/** The error messages for assigning programs to robots, in whole sentences. */
interface RobotMessages {
    /** @param robots the names of the existing robots, never empty. */
    fun unknownRobot(name: String, robots: List<String>): String

    fun tooManyPrograms(robot: String, count: Int, limit: Int): String

    /**
     * Nobody can run a program in a world with [robot] yet.
     *
     * @param title of what it is to be.
     * @param why that is impossible: a sentence.
     */
    fun robotUnfinished(robot: String, title: String, why: String): String
}

internal fun told(reason: ProjectMessages.() -> String): (Language) -> String = { ProjectMessages.of(it).reason() }
