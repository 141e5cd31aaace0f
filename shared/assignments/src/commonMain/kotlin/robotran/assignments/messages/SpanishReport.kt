package robotran.assignments.messages

import robotran.language.listed

internal object SpanishReportMessages : ReportMessages {
    override fun columns(worlds: Int) = listOf(
        "nombre",
        "resultado",
        "metas cumplidas",
        "metas",
        if (worlds == 1) "semillas cumplidas" else "semillas cumplidas (todos los mundos)",
        if (worlds == 1) "semillas" else "semillas (todos los mundos)",
        "segundos",
        "líneas",
        "intentos",
        "observaciones",
        "metas cumplidas en todas las ejecuciones",
        "casi el mismo programa",
        "comentarios",
    )

    override fun assignment() = "tarea"

    override fun meanSeconds() = "segundos (media)"

    override fun solved() = "resuelta"

    override fun partlySolved() = "resuelta en parte"

    override fun notSolved() = "sin resolver"

    override fun hasMistakes() = "tiene errores"

    override fun notGraded() = "sin evaluar"

    override fun unusable() = "no se puede usar"

    override fun countOf(some: Int, all: Int) = "$some de $all"

    override fun summary(handIns: Int, passed: Int) = "Están resueltas $passed de $handIns entregas."

    override fun runsMet(some: Int, all: Int) = if (all == 1) {
        if (some == 1) "Ha cumplido todas las metas." else "No ha cumplido todas las metas."
    } else {
        "Ha cumplido todas las metas en $some de $all ejecuciones."
    }

    override fun plan(worlds: Int, firstSeed: Int, lastSeed: Int): String {
        val seeds = if (firstSeed == lastSeed) "la semilla $firstSeed" else "las semillas $firstSeed a $lastSeed"
        return if (worlds == 1) {
            "Cada una se ha probado con $seeds."
        } else {
            "Cada una se ha probado en $worlds mundos con $seeds."
        }
    }

    override fun ownWorld() = "Mundo dado"

    override fun goal() = "meta"

    override fun seedsMet() = "semillas cumplidas"

    override fun missedWith(seeds: String) = "no cumplida con la semilla $seeds"

    override fun similarHandIns() = "Entregas parecidas"

    override fun similar(names: List<String>, percent: Int) =
        "Los programas de ${listed(names, "y")} son iguales en un $percent % como mínimo."

    override fun equal(names: List<String>) = "${listed(names, "y")} tienen el mismo programa."

    override fun remarks() = "Observaciones"

    override fun programs() = "Programa"

    override fun comment() = "Comentarios"

    override fun feedback() = "comentarios"

    override fun nothingToGrade() = "Robotran no ha encontrado nada tuyo que pueda evaluar."

    override fun notHandIns() = "No son entregas"

    override fun shortened() = "(El resto no se muestra.)"
}
