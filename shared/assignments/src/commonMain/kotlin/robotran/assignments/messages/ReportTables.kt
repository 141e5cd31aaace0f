package robotran.assignments.messages

import robotran.assignments.grading.Verdict

internal object EnglishReportMessages : ReportMessages {
    override fun columns() =
        listOf("name", "verdict", "goals met", "goals", "seeds met", "seeds", "seconds", "lines", "tries", "remarks")

    override fun verdict(verdict: Verdict) = when (verdict) {
        Verdict.PASSED -> "solved"
        Verdict.PARTLY -> "partly solved"
        Verdict.MISSED -> "not solved"
        Verdict.MISTAKES -> "has mistakes"
        Verdict.FAILED -> "not graded"
        Verdict.UNUSABLE -> "cannot be used"
    }

    override fun countOf(some: Int, all: Int) = "$some of $all"

    override fun summary(handIns: Int, passed: Int) = "$passed of $handIns hand-ins are solved."

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) "the seed $firstSeed" else "the seeds $firstSeed to $lastSeed"
        return if (worlds == 1) "Each was run with $seeds." else "Each was run in $worlds worlds with $seeds."
    }

    override fun ownWorld() = "the assignment's world"

    override fun goal() = "goal"

    override fun seedsMet() = "seeds met"

    override fun missedWith(seeds: String) = "missed with seed $seeds"

    override fun similarHandIns() = "Similar hand-ins"

    override fun similar(first: String, second: String, percent: Int) =
        "$first and $second have $percent % of their programs in common."

    override fun equal(first: String, second: String) = "$first and $second have the same program."

    override fun remarks() = "Remarks"

    override fun programs() = "Program"

    override fun comment() = "Comment"

    override fun shortened() = "(The rest is not shown.)"
}

internal object GermanReportMessages : ReportMessages {
    override fun columns() = listOf(
        "Name", "Ergebnis", "Ziele erreicht", "Ziele", "Seeds erreicht", "Seeds", "Sekunden", "Zeilen", "Versuche",
        "Hinweise",
    )

    override fun verdict(verdict: Verdict) = when (verdict) {
        Verdict.PASSED -> "gelöst"
        Verdict.PARTLY -> "teilweise gelöst"
        Verdict.MISSED -> "nicht gelöst"
        Verdict.MISTAKES -> "hat Fehler"
        Verdict.FAILED -> "nicht bewertet"
        Verdict.UNUSABLE -> "nicht brauchbar"
    }

    override fun countOf(some: Int, all: Int) = "$some von $all"

    override fun summary(handIns: Int, passed: Int) = "$passed von $handIns Abgaben sind gelöst."

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) "dem Seed $firstSeed" else "den Seeds $firstSeed bis $lastSeed"
        return if (worlds == 1) "Jede lief mit $seeds." else "Jede lief in $worlds Welten mit $seeds."
    }

    override fun ownWorld() = "die Welt der Aufgabe"

    override fun goal() = "Ziel"

    override fun seedsMet() = "Seeds erreicht"

    override fun missedWith(seeds: String) = "verfehlt mit Seed $seeds"

    override fun similarHandIns() = "Ähnliche Abgaben"

    override fun similar(first: String, second: String, percent: Int) =
        "Die Programme von $first und $second sind zu $percent % gleich."

    override fun equal(first: String, second: String) = "$first und $second haben das gleiche Programm."

    override fun remarks() = "Hinweise"

    override fun programs() = "Programm"

    override fun comment() = "Rückmeldung"

    override fun shortened() = "(Der Rest wird nicht gezeigt.)"
}

internal object SpanishReportMessages : ReportMessages {
    override fun columns() = listOf(
        "nombre", "resultado", "metas cumplidas", "metas", "semillas cumplidas", "semillas", "segundos", "líneas",
        "intentos", "observaciones",
    )

    override fun verdict(verdict: Verdict) = when (verdict) {
        Verdict.PASSED -> "resuelta"
        Verdict.PARTLY -> "resuelta en parte"
        Verdict.MISSED -> "sin resolver"
        Verdict.MISTAKES -> "tiene errores"
        Verdict.FAILED -> "sin evaluar"
        Verdict.UNUSABLE -> "no se puede usar"
    }

    override fun countOf(some: Int, all: Int) = "$some de $all"

    override fun summary(handIns: Int, passed: Int) = "Están resueltas $passed de $handIns entregas."

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) "la semilla $firstSeed" else "las semillas $firstSeed a $lastSeed"
        return if (worlds == 1) "Cada una se ha probado con $seeds." else
            "Cada una se ha probado en $worlds mundos con $seeds."
    }

    override fun ownWorld() = "el mundo de la tarea"

    override fun goal() = "meta"

    override fun seedsMet() = "semillas cumplidas"

    override fun missedWith(seeds: String) = "no cumplida con la semilla $seeds"

    override fun similarHandIns() = "Entregas parecidas"

    override fun similar(first: String, second: String, percent: Int) =
        "Los programas de $first y $second son iguales en un $percent %."

    override fun equal(first: String, second: String) = "$first y $second tienen el mismo programa."

    override fun remarks() = "Observaciones"

    override fun programs() = "Programa"

    override fun comment() = "Comentarios"

    override fun shortened() = "(El resto no se muestra.)"
}
