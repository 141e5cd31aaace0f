package robotran.simulation.messages

import robotran.brick.sensors.SensorKind
import robotran.language.listed
import robotran.language.withComma
import robotran.world.TouchKind

/** The messages in German. */
object GermanSimulationMessages :
    SimulationMessages,
    GoalMessages by GermanGoalMessages,
    ShortfallMessages by GermanShortfallMessages,
    DeviationMessages by GermanDeviationMessages,
    NxtDeviationMessages by GermanNxtDeviationMessages,
    SensorMessages by GermanSensorMessages

/**
 * The goals in German. One term per concept: area - Bereich, barrier - Hindernis, block - Klotz, line - Linie, template
 * - Vorlage.
 */
private object GermanGoalMessages : GoalMessages {
    override fun reach(who: Mover, region: Region, whole: Boolean, within: Int?, stays: Boolean): String {
        val verb = if (who is Mover.Block) "Schieb" else "Bring"
        val way = if (whole) "ganz in den ${named(region)} hinein" else "zum ${named(region)}"
        val end = if (stays) ", und am Ende soll er dort sein" else ""
        return "$verb ${accusative(who)}${within(within)} $way$end."
    }

    override fun stayOut(who: Mover, region: Region, whole: Boolean) =
        "Halt ${part(who, whole)} aus dem ${named(region)} heraus."

    override fun stayIn(who: Mover, region: Region, whole: Boolean) = "Halt ${part(who, whole)} im ${named(region)}."

    override fun neverTouch(who: Mover, what: List<TouchKind>): String {
        val anything = what.size == TouchKind.entries.size
        val things = listed(what.map(::name), "oder")
        return when {
            who != Mover.OwnRobot -> "${nominative(who)} darf nie ${if (anything) "etwas" else things} berühren."
            anything -> "Berühr nie etwas."
            else -> "Berühr nie $things."
        }
    }

    override fun drawTemplate(tolerance: String, coverage: Int) =
        "Zeichne die Vorlage nach: $coverage % davon, und höchstens ${withComma(tolerance)} cm daneben."

    override fun inkLength(atLeast: String?, atMost: String?) = when {
        atMost == null -> "Zeichne ${withComma(atLeast.orEmpty())} cm oder mehr."
        atLeast == null -> "Zeichne nicht mehr als ${withComma(atMost)} cm."
        atLeast == atMost -> "Zeichne ${withComma(atLeast)} cm."
        else -> "Zeichne ${withComma(atLeast)} bis ${withComma(atMost)} cm."
    }

    override fun followLine(who: Mover, line: String?, closed: Boolean, laps: Double, within: Int?): String {
        val name = if (line == null) "der Linie" else "der Linie \"$line\""
        val way = when {
            laps < 1.0 -> " auf ${withComma(number(laps * HUNDRED))} % ihrer Länge"
            closed && laps == 1.0 -> " einmal herum"
            closed -> " ${withComma(number(laps))}-mal herum"
            laps == 1.0 -> " von einem Ende zum anderen"
            else -> " ${withComma(number(laps))}-mal von einem Ende zum anderen"
        }
        val rest = "$name$way${within(within)}"
        return if (who == Mover.OwnRobot) "Folge $rest." else "${nominative(who)} soll $rest folgen."
    }

    override fun endWithin(who: Mover, seconds: Int): String {
        val program = if (who == Mover.OwnRobot) "Dein Programm" else "Das Programm ${genitive(who)}"
        return "$program muss${within(seconds)} zu Ende sein."
    }

    override fun showOnDisplay(who: Mover, text: String, stays: Boolean): String {
        val display = "der Anzeige${if (who == Mover.OwnRobot) "" else " ${genitive(who)}"}"
        return "Zeig \"$text\" auf $display${if (stays) " und lass es am Ende dort stehen" else ""}."
    }

    override fun playSound(who: Mover, times: Int?, lowest: Int?, highest: Int?): String {
        val sounds = when (times) {
            null -> "einen Ton"
            1 -> "genau einen Ton"
            else -> "genau $times Töne"
        }
        val pitch = when {
            lowest == null && highest == null -> ""
            lowest == null -> " mit $highest Hertz oder tiefer"
            highest == null -> " mit $lowest Hertz oder höher"
            lowest == highest -> " mit $lowest Hertz"
            else -> " mit $lowest bis $highest Hertz"
        }
        return if (who == Mover.OwnRobot) "Spiel $sounds$pitch." else "${nominative(who)} soll $sounds$pitch spielen."
    }

    override fun inOrder() = "Mach das der Reihe nach."

    override fun all() = "Mach das alles."

    override fun anyOf() = "Mach eins davon."

    override fun met() = "geschafft"

    override fun notMet() = "nicht geschafft"

    override fun notYet() = "noch nicht"

    private fun nominative(who: Mover): String = when (who) {
        Mover.OwnRobot -> "Dein Roboter"
        is Mover.OtherRobot -> "Der Roboter \"${who.name}\""
        is Mover.Block -> "Der Klotz \"${who.name}\""
    }

    private fun genitive(who: Mover): String = when (who) {
        Mover.OwnRobot -> "deines Roboters"
        is Mover.OtherRobot -> "des Roboters \"${who.name}\""
        is Mover.Block -> "des Klotzes \"${who.name}\""
    }

    private fun accusative(who: Mover): String = when (who) {
        Mover.OwnRobot -> "deinen Roboter"
        is Mover.OtherRobot -> "den Roboter \"${who.name}\""
        is Mover.Block -> "den Klotz \"${who.name}\""
    }

    private fun part(who: Mover, whole: Boolean) = if (whole) "jeden Teil ${genitive(who)}" else accusative(who)

    /** After an article in the dative or the accusative. */
    private fun named(region: Region): String =
        region.name?.let { "Bereich \"$it\"" } ?: "markierten Bereich ${name(region.place)}"

    private fun name(place: PaperSector): String = when (place) {
        PaperSector.TOP_LEFT -> "oben links"
        PaperSector.TOP -> "oben"
        PaperSector.TOP_RIGHT -> "oben rechts"
        PaperSector.LEFT -> "links"
        PaperSector.MIDDLE -> "in der Mitte"
        PaperSector.RIGHT -> "rechts"
        PaperSector.BOTTOM_LEFT -> "unten links"
        PaperSector.BOTTOM -> "unten"
        PaperSector.BOTTOM_RIGHT -> "unten rechts"
    }

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "eine Wand"
        TouchKind.BARRIERS -> "ein Hindernis"
        TouchKind.BLOCKS -> "einen Klotz"
        TouchKind.ROBOTS -> "einen anderen Roboter"
    }

    private fun within(seconds: Int?) = when (seconds) {
        null -> ""
        1 -> " in höchstens 1 Sekunde"
        else -> " in höchstens $seconds Sekunden"
    }

    private const val HUNDRED = 100
}

/** Why a robot strayed, in German. */
private object GermanDeviationMessages : DeviationMessages {
    override fun startPlace(centimetres: String) =
        "Der Roboter wurde ${withComma(centimetres)} cm neben seinen Platz gestellt."

    override fun startHeading(degrees: String, left: Boolean) =
        "Beim Hinstellen schaute er ${withComma(degrees)} Grad zu weit nach ${side(left)}."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "Der ${if (leftMotor) "linke" else "rechte"} Motor ist ${withComma(perCent)} % zu " +
            "${if (weak) "schwach" else "stark"}: " +
            "Sein Rad ist ${withComma(centimetres)} cm ${if (weak) "weniger" else "mehr"} gerollt, als es sollte."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "Die Motoren laufen nicht ganz gleichmäßig: Ein Rad ist dadurch ${withComma(centimetres)} cm mehr gerollt, " +
            "und das hat den Roboter ${withComma(degrees)} Grad nach ${side(left)} gedreht."

    override fun slip(centimetres: String) =
        "Die Räder sind auf dem Boden ein wenig gerutscht und haben zusammen ${withComma(centimetres)} cm verloren."

    override fun spin(centimetres: String) =
        "Die Räder haben sich ${withComma(centimetres)} cm ohne Halt gedreht, weil etwas den Roboter aufgehalten hat."

    override fun battery(volts: String, centimetres: String) =
        "Die Batterien haben nur noch ${withComma(volts)} Volt: Jedes Rad ist ${withComma(centimetres)} cm weniger " +
            "gerollt als mit neuen."

    override fun lightBias(raw: String, dark: Boolean) =
        "Der Lichtsensor misst ${withComma(raw)} Rohwerte zu ${if (dark) "viel" else "wenig"}, " +
            "also sieht für ihn alles ${if (dark) "dunkler" else "heller"} aus, als es ist."

    override fun lightNoise(raw: String) = "Die Werte des Lichtsensors zittern um etwa ${withComma(raw)} Rohwerte."

    override fun bounce(times: Int) = "Die Schalter der Stoßfühler haben beim Anstoßen oder Loslassen " +
        "${if (times == 1) "einmal" else "$times-mal"} geprellt."

    private fun side(left: Boolean) = if (left) "links" else "rechts"
}

private object GermanSensorMessages : SensorMessages {
    override fun missingSensors(ports: Map<SensorKind, List<Int>>): String {
        val (kind, numbers) = ports.entries.first()
        return when {
            ports.size > 1 -> {
                "Es fehlen Sensoren: " +
                    "${listed(ports.map { (kind, numbers) -> "${sensors(kind, numbers)} ${places(numbers)}" }, "und")}."
            }

            numbers.size > 1 -> {
                "${places(numbers).replaceFirstChar { it.uppercase() }} fehlen ${sensors(kind, numbers)}."
            }

            else -> "${places(numbers).replaceFirstChar { it.uppercase() }} fehlt ${sensors(kind, numbers)}."
        }
    }

    private fun places(ports: List<Int>): String =
        (if (ports.size == 1) "an Anschluss " else "an den Anschlüssen ") + listed(ports.map { "$it" }, "und")

    private fun sensors(kind: SensorKind, ports: List<Int>): String {
        val sensor = when (kind) {
            SensorKind.TOUCH -> "Tastsensor"
            SensorKind.TEMPERATURE -> "Temperatursensor"
            SensorKind.LIGHT -> "Lichtsensor"
            SensorKind.ROTATION -> "Drehsensor"
            SensorKind.ULTRASONIC -> "Ultraschallsensor"
            SensorKind.SOUND -> "Geräuschsensor"
            SensorKind.COLOUR -> "Farbsensor"
            SensorKind.COMPASS -> "Kompasssensor"
            SensorKind.GYRO -> "Kreiselsensor"
            SensorKind.HITECHNIC_COLOUR -> "Farbsensor"
            SensorKind.MINDSENSORS_COMPASS -> "Kompasssensor"
            SensorKind.HITECHNIC_ACCELERATION -> "Beschleunigungssensor"
            SensorKind.MINDSENSORS_ACCELERATION -> "Beschleunigungssensor"
            SensorKind.RCX_LIGHT -> "RCX-Lichtsensor"
            SensorKind.RCX_LINK -> "RCX-Sender"
            SensorKind.OPTICAL_DISTANCE -> "Infrarot-Abstandssensor"
            SensorKind.NXT_TEMPERATURE -> "NXT-Temperatursensor"
            SensorKind.INFRARED_SEEKER, SensorKind.INFRARED_SEEKER_2 -> "Infrarotsucher"
        }
        val maker = when (kind) {
            SensorKind.HITECHNIC_COLOUR, SensorKind.HITECHNIC_ACCELERATION -> " von HiTechnic"
            SensorKind.MINDSENSORS_COMPASS, SensorKind.MINDSENSORS_ACCELERATION -> " von mindsensors"
            SensorKind.INFRARED_SEEKER_2 -> " V2"
            else -> ""
        }
        val ending = if (sensor.endsWith("er")) "" else "en"
        return if (ports.size == 1) "ein $sensor$maker" else "$sensor$ending$maker"
    }
}
