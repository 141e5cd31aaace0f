package robotran.simulation.messages

import robotran.brick.sensors.SensorKind
import robotran.language.listed
import robotran.language.withComma
import robotran.world.TouchKind

/** The messages in Spanish. */
object SpanishSimulationMessages :
    SimulationMessages,
    GoalMessages by SpanishGoalMessages,
    ShortfallMessages by SpanishShortfallMessages,
    DeviationMessages by SpanishDeviationMessages,
    NxtDeviationMessages by SpanishNxtDeviationMessages,
    SensorMessages by SpanishSensorMessages

/**
 * The goals in Spanish. One term per concept: area - zona, barrier - obstáculo, block - bloque, line - línea, template
 * - plantilla.
 */
private object SpanishGoalMessages : GoalMessages {
    override fun reach(who: Mover, region: Region, whole: Boolean, within: Int?, stays: Boolean): String {
        val verb = if (who is Mover.Block) "Empuja" else "Lleva"
        val way = if (whole) " entero dentro de" else " hasta"
        val end = if (stays) ", y que esté allí al final" else ""
        return "$verb ${name(who)}$way ${name(region)}${within(within)}$end."
    }

    override fun stayOut(who: Mover, region: Region, whole: Boolean) =
        "Mantén ${part(who, whole)} fuera de ${name(region)}."

    override fun stayIn(who: Mover, region: Region, whole: Boolean) =
        "Mantén ${part(who, whole)} dentro de ${name(region)}."

    override fun neverTouch(who: Mover, what: List<TouchKind>): String {
        val things = if (what.size == TouchKind.entries.size) "nada" else listed(what.map(::name), "ni")
        return if (who == Mover.OwnRobot) {
            "No toques nunca $things."
        } else {
            "${capital(name(who))} no debe tocar nunca $things."
        }
    }

    override fun drawTemplate(tolerance: String, coverage: Int) =
        "Dibuja encima de la plantilla: el $coverage % de ella, y sin salirte más de ${withComma(tolerance)} cm."

    override fun inkLength(atLeast: String?, atMost: String?) = when {
        atMost == null -> "Dibuja ${withComma(atLeast.orEmpty())} cm o más."
        atLeast == null -> "No dibujes más de ${withComma(atMost)} cm."
        atLeast == atMost -> "Dibuja ${withComma(atLeast)} cm."
        else -> "Dibuja entre ${withComma(atLeast)} y ${withComma(atMost)} cm."
    }

    override fun followLine(who: Mover, line: String?, closed: Boolean, laps: Double, within: Int?): String {
        val name = if (line == null) "la línea" else "la línea \"$line\""
        val begin = if (who == Mover.OwnRobot) "Sigue $name" else "${capital(name(who))} debe seguir $name"
        val way = when {
            laps < 1.0 -> " durante el ${withComma(number(laps * HUNDRED))} % de su longitud"
            closed && laps == 1.0 -> " una vuelta"
            closed -> " ${withComma(number(laps))} vueltas"
            laps == 1.0 -> " de un extremo al otro"
            else -> " de un extremo al otro, ${withComma(number(laps))} veces"
        }
        return "$begin$way${within(within)}."
    }

    override fun endWithin(who: Mover, seconds: Int): String {
        val program = if (who == Mover.OwnRobot) "Tu programa" else "El programa ${ofName(who)}"
        return "$program tiene que terminar${within(seconds)}."
    }

    override fun showOnDisplay(who: Mover, text: String, stays: Boolean): String {
        val display = "la pantalla${if (who == Mover.OwnRobot) "" else " ${ofName(who)}"}"
        return "Muestra \"$text\" en $display${if (stays) " y déjalo allí al final" else ""}."
    }

    override fun playSound(who: Mover, times: Int?, lowest: Int?, highest: Int?): String {
        val sounds = when (times) {
            null -> "un tono"
            1 -> "exactamente un tono"
            else -> "exactamente $times tonos"
        }
        val pitch = when {
            lowest == null && highest == null -> ""
            lowest == null -> " de $highest hercios o más grave"
            highest == null -> " de $lowest hercios o más agudo"
            lowest == highest -> " de $lowest hercios"
            else -> " de entre $lowest y $highest hercios"
        }
        return if (who == Mover.OwnRobot) {
            "Haz sonar $sounds$pitch."
        } else {
            "${capital(name(who))} debe hacer sonar $sounds$pitch."
        }
    }

    override fun inOrder() = "Haz esto por orden."

    override fun all() = "Haz todo esto."

    override fun anyOf() = "Haz una de estas cosas."

    override fun met() = "conseguida"

    override fun notMet() = "sin conseguir"

    override fun notYet() = "todavía no"

    private fun name(who: Mover): String = when (who) {
        Mover.OwnRobot -> "tu robot"
        is Mover.OtherRobot -> "el robot \"${who.name}\""
        is Mover.Block -> "el bloque \"${who.name}\""
    }

    private fun ofName(who: Mover): String = when (who) {
        Mover.OwnRobot -> "de tu robot"
        is Mover.OtherRobot -> "del robot \"${who.name}\""
        is Mover.Block -> "del bloque \"${who.name}\""
    }

    private fun part(who: Mover, whole: Boolean) = if (whole) "todas las partes ${ofName(who)}" else name(who)

    private fun name(region: Region): String =
        region.name?.let { "la zona \"$it\"" } ?: "la zona marcada ${name(region.place)}"

    private fun name(place: PaperSector): String = when (place) {
        PaperSector.TOP_LEFT -> "de arriba a la izquierda"
        PaperSector.TOP -> "de arriba"
        PaperSector.TOP_RIGHT -> "de arriba a la derecha"
        PaperSector.LEFT -> "de la izquierda"
        PaperSector.MIDDLE -> "del centro"
        PaperSector.RIGHT -> "de la derecha"
        PaperSector.BOTTOM_LEFT -> "de abajo a la izquierda"
        PaperSector.BOTTOM -> "de abajo"
        PaperSector.BOTTOM_RIGHT -> "de abajo a la derecha"
    }

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "una pared"
        TouchKind.BARRIERS -> "un obstáculo"
        TouchKind.BLOCKS -> "un bloque"
        TouchKind.ROBOTS -> "otro robot"
    }

    private fun capital(words: String) = words.replaceFirstChar { it.uppercaseChar() }

    private fun within(seconds: Int?) = when (seconds) {
        null -> ""
        1 -> " en 1 segundo como mucho"
        else -> " en $seconds segundos como mucho"
    }

    private const val HUNDRED = 100
}

/** Why a robot strayed, in Spanish. */
private object SpanishDeviationMessages : DeviationMessages {
    override fun startPlace(centimetres: String) = "El robot se colocó a ${withComma(centimetres)} cm de su sitio."

    override fun startHeading(degrees: String, left: Boolean) =
        "Al colocarlo, miraba ${withComma(degrees)} grados de más hacia la ${side(left)}."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "El motor ${if (leftMotor) "izquierdo" else "derecho"} es un ${withComma(perCent)} % " +
            "demasiado ${if (weak) "débil" else "fuerte"}: su rueda ha rodado ${withComma(centimetres)} cm " +
            "${if (weak) "menos" else "más"} de lo que debía."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "La velocidad de los motores tiembla: por eso una rueda ha rodado ${withComma(centimetres)} cm más, y el " +
            "robot ha girado " +
            "${withComma(degrees)} grados hacia la ${side(left)}."

    override fun slip(centimetres: String) =
        "Las ruedas han resbalado un poco en el suelo y han perdido ${withComma(centimetres)} cm entre las dos."

    override fun spin(centimetres: String) =
        "Las ruedas han girado ${withComma(centimetres)} cm sin agarrarse, porque algo sujetaba al robot."

    override fun battery(volts: String, centimetres: String) =
        "Las pilas han bajado a ${withComma(volts)} voltios: cada rueda ha rodado ${withComma(centimetres)} cm menos " +
            "que con pilas nuevas."

    override fun lightBias(raw: String, dark: Boolean) =
        "El sensor de luz mide ${withComma(raw)} unidades de ${if (dark) "más" else "menos"}, " +
            "así que lo ve todo más ${if (dark) "oscuro" else "claro"} de lo que es."

    override fun lightNoise(raw: String) = "Lo que mide el sensor de luz tiembla en unas ${withComma(raw)} unidades."

    override fun bounce(times: Int) =
        "Los interruptores de los parachoques han rebotado ${if (times == 1) "una vez" else "$times veces"} al " +
            "chocar o al soltarse."

    private fun side(left: Boolean) = if (left) "izquierda" else "derecha"
}

private object SpanishSensorMessages : SensorMessages {
    override fun missingSensors(ports: Map<SensorKind, List<Int>>): String {
        val sensors = listed(ports.map { (kind, numbers) -> sensors(kind, numbers) }, "y")
        return when {
            ports.size > 1 -> "Faltan sensores: $sensors."
            ports.values.single().size > 1 -> "Faltan $sensors."
            else -> "Falta $sensors."
        }
    }

    private fun sensors(kind: SensorKind, ports: List<Int>): String {
        val numbers = listed(ports.map { "$it" }, "y")
        val (one, several) = words(kind)
        return if (ports.size == 1) "un $one en el puerto $numbers" else "$several en los puertos $numbers"
    }

    private fun words(kind: SensorKind): Pair<String, String> {
        val measure = when (kind) {
            SensorKind.TOUCH -> "contacto"
            SensorKind.TEMPERATURE -> "temperatura"
            SensorKind.LIGHT -> "luz"
            SensorKind.ROTATION -> "giro"
            SensorKind.ULTRASONIC -> "ultrasonidos"
            SensorKind.SOUND -> "sonido"
            SensorKind.COLOUR -> "color"
            SensorKind.COMPASS -> "brújula"
            SensorKind.GYRO -> "giroscopio"
            SensorKind.HITECHNIC_COLOUR -> "color de HiTechnic"
            SensorKind.MINDSENSORS_COMPASS -> "brújula de mindsensors"
            SensorKind.HITECHNIC_ACCELERATION -> "aceleración de HiTechnic"
            SensorKind.MINDSENSORS_ACCELERATION -> "aceleración de mindsensors"
            SensorKind.RCX_LIGHT -> "luz del RCX"
            SensorKind.OPTICAL_DISTANCE -> "distancia por infrarrojos"
            SensorKind.NXT_TEMPERATURE -> "temperatura del NXT"
            SensorKind.RCX_LINK -> return "enlace RCX" to "enlaces RCX"
            SensorKind.INFRARED_SEEKER -> return "buscador de infrarrojos" to "buscadores de infrarrojos"
            SensorKind.INFRARED_SEEKER_2 -> return "buscador de infrarrojos V2" to "buscadores de infrarrojos V2"
        }
        return "sensor de $measure" to "sensores de $measure"
    }
}
