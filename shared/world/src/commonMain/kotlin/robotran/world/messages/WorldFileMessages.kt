package robotran.world.messages

import robotran.language.Language
import robotran.language.choose

/**
 * What is said of world files that cannot be used, beyond [robotran.json.messages.JsonMessages]. Most are what is wrong
 * with a value, and are read behind its path, without a full stop. Fields and their words are quoted as the file has
 * them.
 */
interface WorldFileMessages {
    /** A whole sentence. */
    fun notAWorld(format: String): String

    /** A whole sentence. */
    fun newerWorld(version: Int, known: Int): String

    /** From here on without a full stop. [version] is that of the format which has this field. */
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

    /** @param thing where in the file it is that the robot would start in. */
    fun startsIn(thing: String): String

    /** @param owner where in the file it is that is called so. */
    fun nameTaken(name: String, owner: String): String

    fun mustNameLine(): String

    fun needsTemplate(): String

    fun mustNameRobotOrBlock(): String

    fun mustNameRobot(): String

    fun goalsTooDeep(limit: Int): String

    fun tooManyGoals(limit: Int): String

    fun wordTwice(): String

    fun mustHaveOneOrBoth(one: String, other: String): String

    /** The field [lower] has more than the field [upper]. */
    fun mustNotBeAbove(lower: String, upper: String): String

    companion object {
        fun of(language: Language): WorldFileMessages =
            language.choose(EnglishWorldFileMessages, SpanishWorldFileMessages, GermanWorldFileMessages)
    }
}

internal fun told(reason: WorldFileMessages.() -> String): (Language) -> String = { WorldFileMessages.of(it).reason() }
