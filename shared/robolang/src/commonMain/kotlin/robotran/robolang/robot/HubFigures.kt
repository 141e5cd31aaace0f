package robotran.robolang.robot

import robotran.hub.model.HubColor
import robotran.robolang.robot.HubFigures.FULL_TURN
import kotlin.math.PI
import kotlin.math.floor

/** The figures of the robot statements on a hub with Pybricks, in the interpreter and in Python alike. */
internal object HubFigures {
    /** Degrees a second of a wheel for each step of power. */
    const val SPEED_OF_POWER = 120

    /** Degrees a second of power 0, which a hub refuses. */
    const val SLOWEST_SPEED = 40
    const val HIGHEST_POWER = 7

    /** The power that motors have at first. */
    const val FIRST_POWER = 3

    /** How fast a motor turns by an angle, degrees a second. */
    const val TURNING_SPEED = 360

    /** How fast the pen's motor turns, and how far from up to down. */
    const val PEN_SPEED = 300
    const val PEN_DEGREES = 90

    const val MILLIMETRES_PER_CENTIMETRE = 10
    const val FULL_TURN = 360

    /** The tones of `beep` and `buzz`, in hertz and milliseconds. */
    const val BEEP_HERTZ = 500
    const val BEEP_MILLISECONDS = 100
    const val BUZZ_HERTZ = 100
    const val BUZZ_MILLISECONDS = 500

    /** How long each letter of a text is shown. */
    const val LETTER_MILLISECONDS = 550

    /** The distance with nothing ahead, in centimetres. */
    const val NOTHING = 255

    /** The largest whole number; the smallest is one further from 0. */
    const val LARGEST = (1 shl 30) - 1

    /** The colours that a program tells apart. */
    val COLOURS: List<HubColor> = listOf(
        HubColor.RED,
        HubColor.YELLOW,
        HubColor.GREEN,
        HubColor.BLUE,
        HubColor.WHITE,
        HubColor.BLACK,
    )

    fun speedOf(power: Int): Int = if (power == 0) SLOWEST_SPEED else power * SPEED_OF_POWER
}

/** Millimetres a second with wheels that turn [degrees] a second; a hub refuses more than its motors can do. */
internal fun RobotTarget.Hub.speedAhead(degrees: Int): Int =
    minOf(roundAsPython(wheelSpeed(degrees.toDouble())).toInt(), fastestAhead)

/** Degrees a second that it turns on the spot with them, likewise. */
internal fun RobotTarget.Hub.turnRate(degrees: Int): Int =
    minOf(roundAsPython(degrees * wheelDiameter / track).toInt(), fastestTurn)

/** The most of [speedAhead]. */
internal val RobotTarget.Hub.fastestAhead: Int get() = wheelSpeed(model.motor.highestSpeed.toDouble()).toInt()

/** The most of [turnRate]. */
internal val RobotTarget.Hub.fastestTurn: Int get() = (model.motor.highestSpeed * wheelDiameter / track).toInt()

/** Millimetres a second of a wheel that turns [degrees] a second. */
internal fun RobotTarget.Hub.wheelSpeed(degrees: Double): Double = degrees * PI * wheelDiameter / FULL_TURN

/** The nearest whole number; of two the even one, as Python's `round`. */
internal fun roundAsPython(value: Double): Long {
    val below = floor(value)
    val rest = value - below
    val isUp = rest > HALF || (rest == HALF && below % 2 != 0.0)
    return below.toLong() + if (isUp) 1 else 0
}

private const val HALF = 0.5
