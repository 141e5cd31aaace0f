package robotran.assignments.messages

import robotran.language.listed

internal object GermanReportMessages : ReportMessages {
    override fun columns(worlds: Int) = listOf(
        "Name",
        "Ergebnis",
        "Ziele erreicht",
        "Ziele",
        if (worlds == 1) "Startzahlen erreicht" else "Startzahlen erreicht (alle Welten)",
        if (worlds == 1) "Startzahlen" else "Startzahlen (alle Welten)",
        "Sekunden",
        "Zeilen",
        "Versuche",
        "Hinweise",
        "in allen Läufen erreichte Ziele",
        "fast das gleiche Programm",
        "Rückmeldung",
    )

    override fun assignment() = "Aufgabe"

    override fun meanSeconds() = "Sekunden (Mittel)"

    override fun solved() = "gelöst"

    override fun partlySolved() = "teilweise gelöst"

    override fun notSolved() = "nicht gelöst"

    override fun hasMistakes() = "hat Fehler"

    override fun notGraded() = "nicht bewertet"

    override fun unusable() = "nicht brauchbar"

    override fun countOf(some: Int, all: Int) = "$some von $all"

    override fun summary(handIns: Int, passed: Int) = "$passed von $handIns Abgaben sind gelöst."

    override fun runsMet(some: Int, all: Int) = if (all == 1) {
        if (some == 1) "Hat alle Ziele erreicht." else "Hat nicht alle Ziele erreicht."
    } else {
        "Hat in $some von $all Läufen alle Ziele erreicht."
    }

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) {
            "der Startzahl $firstSeed"
        } else {
            "den Startzahlen $firstSeed bis $lastSeed"
        }
        return if (worlds == 1) "Jede lief mit $seeds." else "Jede lief in $worlds Welten mit $seeds."
    }

    override fun ownWorld() = "Vorgegebene Welt"

    override fun goal() = "Ziel"

    override fun seedsMet() = "Startzahlen erreicht"

    override fun missedWith(seeds: String) = "verfehlt mit Startzahl $seeds"

    override fun similarHandIns() = "Ähnliche Abgaben"

    override fun similar(names: List<String>, percent: Int) =
        "Die Programme von ${listed(names, "und")} sind zu mindestens $percent % gleich."

    override fun equal(names: List<String>) = "${listed(names, "und")} haben das gleiche Programm."

    override fun remarks() = "Hinweise"

    override fun programs() = "Programm"

    override fun comment() = "Rückmeldung"

    override fun feedback() = "Rückmeldung"

    override fun nothingToGrade() = "Robotran hat nichts von dir gefunden, was es bewerten kann."

    override fun notHandIns() = "Keine Abgaben"

    override fun shortened() = "(Der Rest wird nicht gezeigt.)"
}
