package robotran.world.messages

import robotran.json.messages.alternatives

internal object GermanWorldFileMessages : WorldFileMessages {
    override fun notAWorld(format: String) =
        "Das ist keine Welt von Robotran: In einer Weltdatei steht \"format\": \"$format\"."

    override fun newerWorld(version: Int, known: Int) =
        "Diese Welt wurde mit einem neueren Robotran gemacht (sie hat Version $version, dieses Robotran liest bis " +
            "$known)."

    override fun ofVersion(version: Int) =
        "gehört zu Version $version des Formats, aber in dieser Datei steht Version 1"

    override fun besidePaper() = "liegt neben dem Papier"

    override fun noSuchPort(name: String) =
        "darf \"$name\" nicht haben: Ein Stein hat die Anschlüsse \"1\", \"2\" und \"3\""

    override fun sensorTwice() = "darf denselben Sensor nicht zweimal haben"

    override fun samePlaceAsBefore() = "darf nicht derselbe Punkt wie der davor sein"

    override fun firstPlaceAgain() = "darf nicht noch einmal der erste sein, denn die Linie schließt sich von selbst"

    override fun mustBePlace() = "muss ein Punkt wie [20, 30] sein, zuerst x und dann y"

    override fun edgesCross() = "darf keine Kanten haben, die sich kreuzen oder berühren"

    override fun mustCoverPaper() = "muss etwas vom Papier bedecken"

    override fun tooManyPoints(limit: Int) = "ist mehr als die $limit Punkte, die eine Welt zusammen haben darf"

    override fun mustHaveOneOf(words: List<String>) = "muss ${alternatives(words, "oder")} haben"

    override fun mustHaveOnlyOneOf(words: List<String>) = "darf nur eins davon haben: ${alternatives(words, "und")}"

    override fun tooManyCells(limit: Int) =
        "ist mehr als die $limit Kästchen, die alle Graukarten einer Welt zusammen haben dürfen"

    override fun rowLength(length: Int) = "muss so lang wie die erste Reihe sein, $length"

    override fun mustBeGreys() = "muss aus 0 bis 9, a bis f und Punkten bestehen"

    override fun mustBeColour() = "muss eine Farbe wie \"#1133aa\" sein"

    override fun startsIn(thing: String) = "stellt den Roboter in $thing hinein"

    override fun nameTaken(name: String, owner: String) = "darf nicht \"$name\" heißen, denn $owner heißt schon so"

    override fun mustNameLine() = "muss der Name einer Markierung sein, die eine Linie ist"

    override fun needsTemplate() = "braucht eine Vorlage, und diese Welt hat keine"

    override fun mustNameRobotOrBlock() = "muss der Name eines Roboters oder eines Klotzes sein"

    override fun mustNameRobot() = "muss der Name eines Roboters sein"

    override fun goalsTooDeep(limit: Int) = "darf nicht mehr als $limit Ziele ineinander haben"

    override fun tooManyGoals(limit: Int) = "ist mehr als die $limit Ziele, die eine Welt haben darf"

    override fun wordTwice() = "darf dasselbe Wort nicht zweimal haben"

    override fun mustHaveOneOrBoth(one: String, other: String) = "muss \"$one\" oder \"$other\" oder beides haben"

    override fun mustNotBeAbove(lower: String, upper: String) = "darf \"$lower\" nicht größer als \"$upper\" haben"
}
