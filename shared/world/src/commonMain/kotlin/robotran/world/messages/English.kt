package robotran.world.messages

import robotran.json.messages.alternatives

internal object EnglishWorldFileMessages : WorldFileMessages {
    override fun notAWorld(format: String) = "This is not a Robotran world: a world file says \"format\": \"$format\"."

    override fun newerWorld(version: Int, known: Int) =
        "This world was made by a newer Robotran (it has version $version, this Robotran reads up to $known)."

    override fun ofVersion(version: Int) = "belongs to version $version of the format, but this file says version 1"

    override fun besidePaper() = "is beside the paper"

    override fun noSuchPort(name: String) = "must not have \"$name\": a brick has the ports \"1\", \"2\" and \"3\""

    override fun sensorTwice() = "must not have the same sensor twice"

    override fun samePlaceAsBefore() = "must not be the same place as the one before"

    override fun firstPlaceAgain() = "must not be the first one again, since the line is closed anyway"

    override fun mustBePlace() = "must be a place such as [20, 30], first x and then y"

    override fun edgesCross() = "must not have edges that cross or touch each other"

    override fun mustCoverPaper() = "must cover some of the paper"

    override fun tooManyPoints(limit: Int) = "goes beyond the $limit points that a world may have all together"

    override fun mustHaveOneOf(words: List<String>) = "must have ${alternatives(words, "or")}"

    override fun mustHaveOnlyOneOf(words: List<String>) = "must have only one of ${alternatives(words, "and")}"

    override fun tooManyCells(limit: Int) =
        "goes beyond the $limit cells that the grey maps of a world may have all together"

    override fun rowLength(length: Int) = "must be as long as the first row, $length"

    override fun mustBeGreys() = "must be made of 0 to 9, a to f and points"

    override fun mustBeColour() = "must be a colour such as \"#1133aa\""

    override fun startsIn(thing: String) = "puts the robot into $thing"

    override fun nameTaken(name: String, owner: String) =
        "must not be called \"$name\", since $owner is called so already"

    override fun mustNameLine() = "must be the name of a mark that is a line"

    override fun needsTemplate() = "needs a template, and this world has none"

    override fun mustNameRobotOrBlock() = "must be the name of a robot or a block"

    override fun mustNameRobot() = "must be the name of a robot"

    override fun goalsTooDeep(limit: Int) = "must not lie deeper than $limit goals in one another"

    override fun tooManyGoals(limit: Int) = "goes beyond the $limit goals that a world may have"

    override fun wordTwice() = "must not have the same word twice"

    override fun mustHaveOneOrBoth(one: String, other: String) = "must have \"$one\" or \"$other\" or both"

    override fun mustNotBeAbove(lower: String, upper: String) = "must not have \"$lower\" above \"$upper\""
}
