package robotran.simulation.messages

import robotran.language.listed
import robotran.language.withComma
import robotran.world.TouchKind

/** What a run lacked for a goal, in German. */
internal object GermanShortfallMessages : ShortfallMessages {
    override fun impossibleGoal() = "In dieser Welt fehlt das, worum es bei diesem Ziel geht."

    override fun notBegun() = "Das hier zählt erst, wenn das davor geschafft ist."

    override fun notReached(centimetres: String, area: String?) =
        "Bis zum ${name(area)} fehlten noch ${withComma(centimetres)} cm."

    override fun wholeNotReached(centimetres: String, area: String?) =
        "Noch ${withComma(centimetres)} cm, und er wäre ganz im ${name(area)} gewesen."

    override fun partlyOutside(centimetres: String, area: String?) =
        "Ein Teil ragte ${withComma(centimetres)} cm aus dem ${name(area)} heraus."

    override fun reachedTooLate(seconds: String, area: String?) =
        "Er kam in den ${name(area)}, aber ${withComma(seconds)} s zu spät."

    override fun leftAgain(time: String, centimetres: String, area: String?) =
        "Er war im ${name(area)}, hat ihn aber bei ${withComma(time)} s verlassen. " +
            "Am Ende war er ${withComma(centimetres)} cm davon weg."

    override fun entered(time: String, area: String?) = "Er war bei ${withComma(time)} s im ${name(area)}."

    override fun left(time: String, area: String?) = "Er hat den ${name(area)} bei ${withComma(time)} s verlassen."

    override fun touched(time: String, what: List<TouchKind>, name: String?): String {
        val thing = if (name == null) listed(what.map(::name), "und") else "${nameWithThe(what.first())} \"$name\""
        return "Er hat bei ${withComma(time)} s $thing berührt."
    }

    override fun inkTooShort(centimetres: String) = "Die Zeichnung ist ${withComma(centimetres)} cm zu kurz."

    override fun inkTooLong(time: String, centimetres: String) =
        "Bei ${withComma(time)} s war die Zeichnung lang genug. " +
            "Danach kamen ${withComma(centimetres)} cm zu viel dazu."

    override fun templateMissing(share: Int, wanted: Int) =
        "$share % der Vorlage sind gezeichnet, $wanted % sollen es sein."

    override fun inkBesideTemplate(centimetres: String) =
        "${withComma(centimetres)} cm liegen neben der Vorlage. Das ist zu viel."

    override fun lineNotReached(centimetres: String) =
        "Der Lichtsensor hat die Linie nicht gefunden. Näher als ${withComma(centimetres)} cm kam er nicht heran."

    override fun lineLeft(time: String, share: Int) =
        "Bei ${withComma(time)} s hat er die Linie verlassen, nach $share % des Wegs."

    override fun lineBeganAgain(time: String) = "Bei ${withComma(time)} s hat er die Linie verlassen und anderswo " +
        "wiedergefunden. Dort fing der Weg von vorne an."

    override fun lineUnfinished(share: Int) = "$share % des Wegs auf der Linie sind geschafft."

    override fun lineTooLate(seconds: String) =
        "Der ganze Weg auf der Linie ist geschafft, aber ${withComma(seconds)} s zu spät."

    override fun stillRunning(time: String) = "Bei ${withComma(time)} s lief das Programm noch."

    override fun endedTooLate(seconds: String) = "Das Programm war ${withComma(seconds)} s zu spät zu Ende."

    override fun wasStopped(time: String) = "Das Programm wurde vor seinem Ende angehalten. " +
        "Bei ${withComma(time)} s war es noch nicht von selbst zu Ende."

    override fun hasFailed() = "Das Programm musste wegen eines Fehlers anhalten."

    override fun notStarted() = "Das Programm wurde nicht gestartet."

    override fun displayBlank(wanted: String) =
        "Das Programm hat nichts auf der Anzeige gezeigt, \"$wanted\" soll es sein."

    override fun displayDiffered(wanted: String, last: String) =
        "Auf der Anzeige stand \"$last\", \"$wanted\" soll es sein."

    override fun displayNearly(wanted: String, nearest: String, time: String) =
        "Bei ${withComma(time)} s stand \"$nearest\" auf der Anzeige. Das ist nah dran, \"$wanted\" soll es sein."

    override fun displayChanged(wanted: String, last: String?, time: String): String {
        val now = if (last == null) "Am Ende ist sie leer." else "Am Ende steht dort \"$last\"."
        return "Auf der Anzeige stand \"$wanted\" bis ${withComma(time)} s. $now"
    }

    override fun tooManyTones(played: Int, wanted: Int) =
        "$played Töne wurden gespielt, $wanted ${if (wanted == 1) "soll" else "sollen"} es sein."

    override fun tonesMissing(played: Int, wanted: Int) =
        "$played von $wanted Tönen ${if (played == 1) "wurde" else "wurden"} gespielt."

    override fun otherTones(played: Int, wanted: Int, others: Int, hertz: Int): String {
        val more = if (others == 1) "Ein anderer war" else "$others andere waren"
        val first = if (others == 1) "er hatte" else "der erste hatte"
        return "${tonesMissing(played, wanted)} $more zu hoch oder zu tief: $first $hertz Hertz."
    }

    /** After an article. */
    private fun name(area: String?) = if (area == null) "markierten Bereich" else "Bereich \"$area\""

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "eine Wand"
        TouchKind.BARRIERS -> "ein Hindernis"
        TouchKind.BLOCKS -> "einen Klotz"
        TouchKind.ROBOTS -> "einen anderen Roboter"
    }

    private fun nameWithThe(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "die Wand"
        TouchKind.BARRIERS -> "das Hindernis"
        TouchKind.BLOCKS -> "den Klotz"
        TouchKind.ROBOTS -> "den Roboter"
    }
}
