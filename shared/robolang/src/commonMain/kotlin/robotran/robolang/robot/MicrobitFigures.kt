package robotran.robolang.robot

import robotran.brick.kind.WheelTrim
import robotran.microbit.buggy.PenServo

/**
 * The figures of the robot statements on a micro:bit buggy, in the interpreter and in Python alike. The real speed is not
 * known: pupils measure their buggy, at power 3.
 */
object MicrobitFigures {
    /** Percent of the most for each step of power: below 20 % many buggies only hum. */
    val PERCENT_OF_POWER: List<Int> = listOf(0, 20, 30, 45, 55, 70, 85, 100)

    /** The power that wheels have at first. */
    const val FIRST_POWER = 3

    /** The tones of `beep` and `buzz`, in hertz and milliseconds. */
    const val BEEP_HERTZ = 880
    const val BEEP_MILLISECONDS = 100
    const val BUZZ_HERTZ = 110
    const val BUZZ_MILLISECONDS = 200

    /** The angles of the servo of the pen, degrees, and how long it takes from one to the other. */
    const val PEN_UP_DEGREES = PenServo.UP_DEGREES
    const val PEN_DOWN_DEGREES = PenServo.DOWN_DEGREES
    const val PEN_MILLISECONDS = 200

    /** Time between two measurements of a distance, so that old echoes do not count; in between the last one stands. */
    const val SONAR_MILLISECONDS = 60

    /** The distance with nothing ahead, in centimetres. */
    const val NOTHING = 255

    /** What a line sensor that knows only two values says. */
    const val DARK = 0
    const val BRIGHT = 100

    /** The most that the lights and the microphone of the board measure. */
    const val FULL_LEVEL = 255

    /** Percent for a wheel with this power, 0..7, and this [factor] of its trim; halves round up. */
    fun percentOf(power: Int, factor: Double): Int = WheelTrim.percentOf(PERCENT_OF_POWER[power], factor)
}
