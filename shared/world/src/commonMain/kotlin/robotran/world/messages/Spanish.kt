package robotran.world.messages

import robotran.json.messages.alternatives

internal object SpanishWorldFileMessages : WorldFileMessages {
    override fun notAWorld(format: String) =
        "Esto no es un mundo de Robotran: un archivo de mundo dice \"format\": \"$format\"."

    override fun newerWorld(version: Int, known: Int) =
        "Este mundo se hizo con un Robotran más nuevo (tiene la versión $version, y este Robotran lee hasta la $known)."

    override fun ofVersion(version: Int) = "es de la versión $version del formato, pero este archivo dice versión 1"

    override fun besidePaper() = "está fuera del papel"

    override fun noSuchPort(name: String) =
        "no puede tener \"$name\": un ladrillo tiene los puertos \"1\", \"2\" y \"3\""

    override fun sensorTwice() = "no puede tener dos veces el mismo sensor"

    override fun samePlaceAsBefore() = "no puede ser el mismo lugar que el anterior"

    override fun firstPlaceAgain() = "no puede ser otra vez el primero, porque la línea ya se cierra sola"

    override fun mustBePlace() = "tiene que ser un lugar como [20, 30], primero x y luego y"

    override fun edgesCross() = "no puede tener lados que se crucen o se toquen"

    override fun mustCoverPaper() = "tiene que cubrir algo del papel"

    override fun tooManyPoints(limit: Int) = "pasa de los $limit puntos que puede tener un mundo en total"

    override fun mustHaveOneOf(words: List<String>) = "tiene que tener ${alternatives(words, "o")}"

    override fun mustHaveOnlyOneOf(words: List<String>) =
        "solo puede tener una de estas cosas: ${alternatives(words, "y")}"

    override fun tooManyCells(limit: Int) =
        "pasa de los $limit cuadros que pueden tener en total los mapas de grises de un mundo"

    override fun rowLength(length: Int) = "tiene que ser tan larga como la primera fila, $length"

    override fun mustBeGreys() = "tiene que estar hecha de 0 a 9, de a hasta f y de puntos"

    override fun mustBeColour() = "tiene que ser un color como \"#1133aa\""

    override fun startsIn(thing: String) = "mete el robot dentro de $thing"

    override fun nameTaken(name: String, owner: String) = "no puede llamarse \"$name\", porque $owner ya se llama así"

    override fun mustNameLine() = "tiene que ser el nombre de una marca que sea una línea"

    override fun needsTemplate() = "necesita una plantilla, y este mundo no tiene ninguna"

    override fun mustNameRobotOrBlock() = "tiene que ser el nombre de un robot o de un bloque"

    override fun mustNameRobot() = "tiene que ser el nombre de un robot"

    override fun goalsTooDeep(limit: Int) = "no puede tener más de $limit metas unas dentro de otras"

    override fun tooManyGoals(limit: Int) = "pasa de los $limit metas que puede tener un mundo"

    override fun wordTwice() = "no puede tener dos veces la misma palabra"

    override fun mustHaveOneOrBoth(one: String, other: String) = "tiene que tener \"$one\" o \"$other\", o los dos"

    override fun mustNotBeAbove(lower: String, upper: String) = "no puede tener \"$lower\" mayor que \"$upper\""
}
