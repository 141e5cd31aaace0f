package robotran.simulation.messages

import robotran.language.listed
import robotran.language.withComma
import robotran.world.TouchKind

/** What a run lacked for a goal, in Spanish. */
internal object SpanishShortfallMessages : ShortfallMessages {
    override fun impossibleGoal() = "En este mundo falta aquello de lo que trata esta meta."

    override fun notBegun() = "Esta solo cuenta cuando la anterior está hecha."

    override fun notReached(centimetres: String, area: String?) =
        "Faltaron ${withComma(centimetres)} cm para llegar a ${name(area)}."

    override fun wholeNotReached(centimetres: String, area: String?) =
        "Con ${withComma(centimetres)} cm más habría estado entero dentro de ${name(area)}."

    override fun partlyOutside(centimetres: String, area: String?) =
        "Una parte se quedó ${withComma(centimetres)} cm fuera de ${name(area)}."

    override fun reachedTooLate(seconds: String, area: String?) =
        "Llegó a ${name(area)}, pero ${withComma(seconds)} s tarde."

    override fun leftAgain(time: String, centimetres: String, area: String?) =
        "Estuvo en ${name(area)}, pero salió en el segundo ${withComma(time)}. " +
            "Al final estaba a ${withComma(centimetres)} cm."

    override fun entered(time: String, area: String?) = "En el segundo ${withComma(time)} estaba en ${name(area)}."

    override fun left(time: String, area: String?) = "En el segundo ${withComma(time)} salió de ${name(area)}."

    override fun touched(time: String, what: List<TouchKind>, name: String?): String {
        val thing = if (name == null) listed(what.map(::name), "y") else "${nameWithThe(what.first())} \"$name\""
        return "En el segundo ${withComma(time)} tocó $thing."
    }

    override fun inkTooShort(centimetres: String) = "Al dibujo le faltan ${withComma(centimetres)} cm."

    override fun inkTooLong(time: String, centimetres: String) =
        "En el segundo ${withComma(time)} el dibujo ya era bastante largo. Después sobran ${withComma(centimetres)} cm."

    override fun templateMissing(share: Int, wanted: Int) =
        "Está dibujado el $share % de la plantilla, y hace falta el $wanted %."

    override fun inkBesideTemplate(centimetres: String) =
        "Hay ${withComma(centimetres)} cm dibujados fuera de la plantilla. Es demasiado."

    override fun lineNotReached(centimetres: String) = "El sensor de luz no encontró la línea. " +
        "Lo más cerca que estuvo fue a ${withComma(centimetres)} cm."

    override fun lineLeft(time: String, share: Int) =
        "En el segundo ${withComma(time)} se salió de la línea, después del $share % del camino."

    override fun lineBeganAgain(time: String) = "En el segundo ${withComma(time)} se salió de la línea y la encontró " +
        "en otro sitio. Allí el camino empezó de nuevo."

    override fun lineUnfinished(share: Int) = "Está hecho el $share % del camino por la línea."

    override fun lineTooLate(seconds: String) =
        "Está hecho todo el camino por la línea, pero ${withComma(seconds)} s tarde."

    override fun stillRunning(time: String) = "En el segundo ${withComma(time)} el programa todavía no había terminado."

    override fun endedTooLate(seconds: String) = "El programa terminó ${withComma(seconds)} s tarde."

    override fun wasStopped(time: String) = "Alguien paró el programa antes de su fin. " +
        "En el segundo ${withComma(time)} no había terminado por sí solo."

    override fun hasFailed() = "El programa tuvo que parar por un error."

    override fun notStarted() = "El programa no se puso en marcha."

    override fun displayBlank(wanted: String) = "El programa no mostró nada en la pantalla, y hace falta \"$wanted\"."

    override fun displayDiffered(wanted: String, last: String) =
        "En la pantalla ponía \"$last\", y hace falta \"$wanted\"."

    override fun displayNearly(wanted: String, nearest: String, time: String) =
        "En el segundo ${withComma(time)} la pantalla mostró \"$nearest\". Se parece, pero hace falta \"$wanted\"."

    override fun displayChanged(wanted: String, last: String?, time: String): String {
        val now = if (last == null) "Al final está vacía." else "Al final pone \"$last\"."
        return "En la pantalla ponía \"$wanted\" hasta los ${withComma(time)} s. $now"
    }

    override fun tooManyTones(played: Int, wanted: Int) =
        "Sonaron $played tonos, y ${if (wanted == 1) "tiene" else "tienen"} que sonar $wanted."

    override fun tonesMissing(played: Int, wanted: Int) =
        "${if (played == 1) "Sonó" else "Sonaron"} $played de $wanted tonos."

    override fun otherTones(played: Int, wanted: Int, others: Int, hertz: Int): String {
        val more = if (others == 1) {
            "Otro era demasiado agudo o grave"
        } else {
            "Otros $others eran demasiado agudos o graves"
        }
        val first = if (others == 1) "tenía" else "el primero tenía"
        return "${tonesMissing(played, wanted)} $more: $first $hertz hercios."
    }

    private fun name(area: String?) = if (area == null) "la zona marcada" else "la zona \"$area\""

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "una pared"
        TouchKind.BARRIERS -> "un obstáculo"
        TouchKind.BLOCKS -> "un bloque"
        TouchKind.ROBOTS -> "otro robot"
    }

    private fun nameWithThe(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "la pared"
        TouchKind.BARRIERS -> "el obstáculo"
        TouchKind.BLOCKS -> "el bloque"
        TouchKind.ROBOTS -> "el robot"
    }
}
