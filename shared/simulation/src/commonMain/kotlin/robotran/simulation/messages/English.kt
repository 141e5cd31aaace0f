package robotran.simulation.messages

import robotran.brick.sensors.SensorKind
import robotran.language.listed
import robotran.world.TouchKind

object EnglishSimulationMessages :
    SimulationMessages,
    GoalMessages by EnglishGoalMessages,
    ShortfallMessages by EnglishShortfallMessages,
    DeviationMessages by EnglishDeviationMessages,
    NxtDeviationMessages by EnglishNxtDeviationMessages,
    SensorMessages by EnglishSensorMessages

private object EnglishGoalMessages : GoalMessages {
    override fun reach(who: Mover, region: Region, whole: Boolean, within: Int?, stays: Boolean): String {
        val verb = if (who is Mover.Block) "Push" else "Drive"
        val all = if (whole) "all of " else ""
        val end = if (stays) ", and let it be there at the end" else ""
        return "$verb $all${name(who)} ${if (whole) "into" else "to"} ${name(region)}${within(within)}$end."
    }

    override fun stayOut(who: Mover, region: Region, whole: Boolean) =
        "Keep ${part(who, whole)} out of ${name(region)}."

    override fun stayIn(who: Mover, region: Region, whole: Boolean) = "Keep ${part(who, whole)} in ${name(region)}."

    override fun neverTouch(who: Mover, what: List<TouchKind>): String {
        val things = if (what.size == TouchKind.entries.size) "anything" else listed(what.map(::name), "or")
        return if (who == Mover.OwnRobot) "Never touch $things." else "Let ${name(who)} never touch $things."
    }

    override fun drawTemplate(tolerance: String, coverage: Int) =
        "Draw over the template: $coverage % of it, and not more than $tolerance cm beside it."

    override fun inkLength(atLeast: String?, atMost: String?) = when {
        atMost == null -> "Draw $atLeast cm or more."
        atLeast == null -> "Do not draw more than $atMost cm."
        atLeast == atMost -> "Draw $atLeast cm."
        else -> "Draw $atLeast to $atMost cm."
    }

    override fun followLine(who: Mover, line: String?, closed: Boolean, laps: Double, within: Int?): String {
        val name = if (line == null) "the line" else "the line \"$line\""
        val begin = if (who == Mover.OwnRobot) "Follow $name" else "Let ${name(who)} follow $name"
        val way = when {
            laps < 1.0 -> " for ${number(laps * HUNDRED)} % of its length"
            closed && laps == 1.0 -> " once round"
            closed -> " ${number(laps)} times round"
            laps == 1.0 -> " from one end to the other"
            else -> " from one end to the other, ${number(laps)} times"
        }
        return "$begin$way${within(within)}."
    }

    override fun endWithin(who: Mover, seconds: Int): String {
        val program = if (who == Mover.OwnRobot) "Your program" else "The program of ${name(who)}"
        return "$program must come to its end within ${seconds(seconds)}."
    }

    override fun showOnDisplay(who: Mover, text: String, stays: Boolean) =
        "Show \"$text\" on ${display(who)}${if (stays) ", and leave it there at the end" else ""}."

    override fun playSound(who: Mover, times: Int?, lowest: Int?, highest: Int?): String {
        val sounds = when (times) {
            null -> "a tone"
            1 -> "exactly one tone"
            else -> "exactly $times tones"
        }
        val pitch = when {
            lowest == null && highest == null -> ""
            lowest == null -> " of $highest hertz or lower"
            highest == null -> " of $lowest hertz or higher"
            lowest == highest -> " of $lowest hertz"
            else -> " of $lowest to $highest hertz"
        }
        return if (who == Mover.OwnRobot) "Play $sounds$pitch." else "Let ${name(who)} play $sounds$pitch."
    }

    override fun inOrder() = "Do these one after the other."

    override fun all() = "Do all of these."

    override fun anyOf() = "Do one of these."

    override fun met() = "met"

    override fun notMet() = "not met"

    override fun notYet() = "not yet"

    private fun name(who: Mover): String = when (who) {
        Mover.OwnRobot -> "your robot"
        is Mover.OtherRobot -> "the robot \"${who.name}\""
        is Mover.Block -> "the block \"${who.name}\""
    }

    private fun part(who: Mover, whole: Boolean) = if (whole) "every part of ${name(who)}" else name(who)

    private fun display(who: Mover) = if (who == Mover.OwnRobot) "the display" else "the display of ${name(who)}"

    private fun name(region: Region): String =
        region.name?.let { "the area \"$it\"" } ?: "the marked area ${name(region.place)}"

    private fun name(place: PaperSector): String = when (place) {
        PaperSector.TOP_LEFT -> "at the top left"
        PaperSector.TOP -> "at the top"
        PaperSector.TOP_RIGHT -> "at the top right"
        PaperSector.LEFT -> "on the left"
        PaperSector.MIDDLE -> "in the middle"
        PaperSector.RIGHT -> "on the right"
        PaperSector.BOTTOM_LEFT -> "at the bottom left"
        PaperSector.BOTTOM -> "at the bottom"
        PaperSector.BOTTOM_RIGHT -> "at the bottom right"
    }

    private fun name(kind: TouchKind): String = when (kind) {
        TouchKind.WALLS -> "a wall"
        TouchKind.BARRIERS -> "a barrier"
        TouchKind.BLOCKS -> "a block"
        TouchKind.ROBOTS -> "another robot"
    }

    private fun within(seconds: Int?) = if (seconds == null) "" else " within ${seconds(seconds)}"

    private fun seconds(seconds: Int) = if (seconds == 1) "1 second" else "$seconds seconds"

    private const val HUNDRED = 100
}

/** Why a robot strayed, in English. */
private object EnglishDeviationMessages : DeviationMessages {
    override fun startPlace(centimetres: String) = "The robot was put down $centimetres cm beside its place."

    override fun startHeading(degrees: String, left: Boolean) =
        "It looked $degrees degrees too far to the ${side(left)} when it was put down."

    override fun strength(leftMotor: Boolean, weak: Boolean, perCent: String, centimetres: String) =
        "The ${side(leftMotor)} motor is $perCent % too ${if (weak) "weak" else "strong"}: its wheel rolled " +
            "$centimetres cm ${if (weak) "less" else "more"} than it should."

    override fun flutter(centimetres: String, degrees: String, left: Boolean) =
        "The motors' speeds flutter: one wheel rolled $centimetres cm more by that, which turned the robot $degrees " +
            "degrees to the ${side(left)}."

    override fun slip(centimetres: String) =
        "The wheels slipped a little on the floor and lost $centimetres cm together."

    override fun spin(centimetres: String) =
        "The wheels turned $centimetres cm without grip, because something held the robot."

    override fun battery(volts: String, centimetres: String) =
        "The batteries are down to $volts volts: each wheel rolled $centimetres cm less than with fresh ones."

    override fun lightBias(raw: String, dark: Boolean) = "The light sensor measures $raw raw units too " +
        "${if (dark) "much, so everything looks darker" else "little, so everything looks lighter"} to it than it is."

    override fun lightNoise(raw: String) = "The light sensor's readings flicker by about $raw raw units."

    override fun bounce(times: Int) =
        "The switches of the bumpers bounced ${if (times == 1) "once" else "$times times"} when they were hit or let " +
            "go."

    private fun side(left: Boolean) = if (left) "left" else "right"
}

private object EnglishSensorMessages : SensorMessages {
    override fun missingSensors(ports: Map<SensorKind, List<Int>>): String {
        val (kind, numbers) = ports.entries.first()
        return when {
            ports.size > 1 -> {
                "Sensors are missing: " +
                    "${listed(ports.map { (kind, numbers) -> "${sensors(kind, numbers)} ${places(numbers)}" }, "and")}."
            }

            numbers.size > 1 -> {
                "${sensors(kind, numbers).replaceFirstChar { it.uppercase() }} are missing ${places(numbers)}."
            }

            else -> "${sensors(kind, numbers).replaceFirstChar { it.uppercase() }} is missing ${places(numbers)}."
        }
    }

    private fun places(ports: List<Int>): String =
        (if (ports.size == 1) "on port " else "on ports ") + listed(ports.map { "$it" }, "and")

    private fun sensors(kind: SensorKind, ports: List<Int>): String {
        val sensor = when (kind) {
            SensorKind.TOUCH -> "touch sensor"
            SensorKind.TEMPERATURE -> "temperature sensor"
            SensorKind.LIGHT -> "light sensor"
            SensorKind.ROTATION -> "rotation sensor"
            SensorKind.ULTRASONIC -> "ultrasonic sensor"
            SensorKind.SOUND -> "sound sensor"
            SensorKind.COLOUR -> "colour sensor"
            SensorKind.COMPASS -> "compass sensor"
            SensorKind.GYRO -> "gyro sensor"
            SensorKind.HITECHNIC_COLOUR -> "HiTechnic colour sensor"
            SensorKind.MINDSENSORS_COMPASS -> "mindsensors compass sensor"
            SensorKind.HITECHNIC_ACCELERATION -> "HiTechnic acceleration sensor"
            SensorKind.MINDSENSORS_ACCELERATION -> "mindsensors acceleration sensor"
            SensorKind.RCX_LIGHT -> "RCX light sensor"
            SensorKind.RCX_LINK -> "RCX link"
            SensorKind.OPTICAL_DISTANCE -> "optical distance sensor"
            SensorKind.NXT_TEMPERATURE -> "NXT temperature sensor"
            SensorKind.INFRARED_SEEKER -> "infrared seeker"
            SensorKind.INFRARED_SEEKER_2 -> "infrared seeker V2"
        }
        val article = if (sensor.first() in "uoiRN") "an" else "a"
        return if (ports.size == 1) "$article $sensor" else "${sensor}s"
    }
}
