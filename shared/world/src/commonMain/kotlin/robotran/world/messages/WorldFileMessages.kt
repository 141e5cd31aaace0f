package robotran.world.messages

import robotran.language.Language
import robotran.language.choose

/**
 * The error messages for world files, in addition to [robotran.json.messages.JsonMessages]. Most describe what is wrong
 * with a value and follow its path, without a full stop. Fields and keywords are quoted as in the file.
 */
interface WorldFileMessages {
    /** A whole sentence. */
    fun notAWorld(format: String): String

    /** A whole sentence. */
    fun newerWorld(version: Int, known: Int): String

    /** From here on without a full stop. [version] is the format version that has this field. */
    fun ofVersion(version: Int): String

    fun besidePaper(): String

    fun noSuchPort(name: String): String

    fun sensorTwice(): String

    fun samePlaceAsBefore(): String

    fun firstPlaceAgain(): String

    fun mustBePlace(): String

    fun edgesCross(): String

    fun mustCoverPaper(): String

    fun tooManyPoints(limit: Int): String

    fun mustHaveOneOf(words: List<String>): String

    fun mustHaveOnlyOneOf(words: List<String>): String

    fun tooManyCells(limit: Int): String

    fun rowLength(length: Int): String

    fun mustBeGreys(): String

    fun mustBeColour(): String

    /** @param thing the path of the obstacle at the robot's start. */
    fun startsIn(thing: String): String

    /** @param owner the path of the element that has the name. */
    fun nameTaken(name: String, owner: String): String

    fun mustNameLine(): String

    fun needsTemplate(): String

    fun mustNameRobotOrBlock(): String

    fun mustNameRobot(): String

    fun goalsTooDeep(limit: Int): String

    fun tooManyGoals(limit: Int): String

    fun wordTwice(): String

    fun mustHaveOneOrBoth(one: String, other: String): String

    /** The value of field [lower] is above that of field [upper]. */
    fun mustNotBeAbove(lower: String, upper: String): String

    companion object {
        fun of(language: Language): WorldFileMessages =
            language.choose(EnglishWorldFileMessages, SpanishWorldFileMessages, GermanWorldFileMessages)
    }
}

internal fun told(reason: WorldFileMessages.() -> String): (Language) -> String = { WorldFileMessages.of(it).reason() }
