package robotran.robolang.messages

import robotran.language.quoted

/** What a pupil is told in German when a program cannot go on. */
internal object GermanRunMessages : RunMessages {
    override fun divisionByZero(dividend: String) = "$dividend kann man nicht durch 0 teilen."

    override fun indexOutside(index: Int, size: Int) = when (size) {
        0 -> "Es gibt kein Element $index, die Liste ist leer."
        1 -> "Es gibt kein Element $index in einer Liste von 1, nur das Element 0."
        else -> "Es gibt kein Element $index in einer Liste von $size. Gezählt wird von 0 bis ${size - 1}."
    }

    override fun tooManyCalls(name: String, limit: Int) =
        "${quoted(name)} ruft sich zu oft selbst auf: Im Speicher des Steins ist nur Platz für $limit Aufrufe " +
            "ineinander."

    override fun listsTooLarge(limit: Int) =
        "Der Speicher des Steins ist voll: Alle Listen bis jetzt haben zusammen mehr als $limit Elemente, und er " +
            "behält jedes."

    override fun negativeTime(value: String) = "Eine Zeit von $value gibt es für den Roboter nicht. Nimm 0 oder mehr."

    override fun negativeCount(value: Int) = "Nichts kann $value-mal wiederholt werden. Nimm 0 oder mehr."

    override fun powerOutside(value: Int) = "Ein Motor hat keine Leistung $value, nur 0 bis 7."

    override fun stepOfNothing() = "Mit Schritten von 0 käme die Schleife nie weiter."

    override fun rootOfNegative(value: String) = "$value hat keine Quadratwurzel, denn es ist kleiner als 0."

    override fun powerOfNegative(base: String, exponent: String) = "Es gibt keine Zahl, die $base hoch $exponent ist."

    override fun nothingReturned(name: String) = "Die Funktion ${quoted(name)} kam ohne ein \"return\" an ihr Ende."
}
