package robotran.robolang.python

/** The figures of commands on a hub with Pybricks. */
internal object PybricksFigures {
    /** Degrees a second of a wheel for each step of power, as on an NXT. */
    const val SPEED_OF_POWER = 120

    /** The power that motors have at first. */
    const val FIRST_POWER = 3

    /** Degrees a second of power 0, as on an NXT: a hub refuses 0. */
    const val SLOWEST_SPEED = 40
    const val FULL_TURN = 360

    /** How fast a motor turns by an angle, in degrees a second. */
    const val TURNING_SPEED = 360

    /** How fast the pen's motor turns. */
    const val PEN_SPEED = 300

    /** How far it turns from up to down. */
    const val PEN_DEGREES = 90

    /** The largest whole number of a hub. */
    const val LARGEST = (1 shl 30) - 1
    const val BUZZ_HERTZ = 100
    const val BUZZ_MILLISECONDS = 500
    const val BEEP_MILLISECONDS = 100

    /** How long a loop that does nothing else waits, in milliseconds. */
    const val PAUSE = 10

    fun speedOf(power: Int): Int = if (power == 0) SLOWEST_SPEED else power * SPEED_OF_POWER
}

/** Millimetres a second that the robot drives with wheels that turn so many [degrees] a second. */
internal fun PybricksRobot.speedAhead(degrees: Int): Long =
    roundAsPython(degrees * kotlin.math.PI * wheelDiameter / PybricksFigures.FULL_TURN)

/** Degrees a second that it turns on the spot with them. */
internal fun PybricksRobot.turnRate(degrees: Int): Long = roundAsPython(degrees * wheelDiameter / track)

/** [figure] with at most three digits behind its point, and none that says nothing. */
internal fun decimalFigure(figure: Double): String {
    val thousandths = roundAsPython(figure * THOUSAND)
    val whole = thousandths / THOUSAND
    val rest = "${thousandths % THOUSAND}".padStart(DIGITS, '0').trimEnd('0')
    return if (rest.isEmpty()) "$whole" else "$whole.$rest"
}

private const val THOUSAND = 1000
private const val DIGITS = 3
