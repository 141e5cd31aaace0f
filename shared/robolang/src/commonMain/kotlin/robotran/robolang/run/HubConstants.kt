package robotran.robolang.run

/** Constants of the robot statements on a hub with Pybricks. */
internal object HubConstants {
    /** Degrees a second of a wheel for each step of power, and of power 0, which a hub refuses. */
    const val SPEED_OF_POWER = 120
    const val SLOWEST_SPEED = 40

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

    fun speedOf(power: Int): Int = if (power == 0) SLOWEST_SPEED else power * SPEED_OF_POWER
}
