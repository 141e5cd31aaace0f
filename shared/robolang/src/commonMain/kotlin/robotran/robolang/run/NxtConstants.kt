package robotran.robolang.run

/** Constants of the robot statements on an NXT. */
internal object NxtConstants {
    /** How far the pen's motor turns from up to down, in degrees. */
    const val PEN_DEGREES = 90

    /** The power that motors have at first. */
    const val FIRST_POWER = 3

    /** The loudness of tones: leJOS NXJ's default. */
    const val VOLUME = 80

    /** Degrees a second for each step of a motor's power: with 3 a wheel turns once a second, leJOS NXJ's default. */
    const val SPEED_OF_POWER = 120

    /** Degrees a second of power 0: at rest a drive would never end. */
    const val SLOWEST_SPEED = 40

    /** The default acceleration of leJOS NXJ's motors, in degrees a second squared. */
    const val ACCELERATION = 6000

    /** How long a program waits until the brick has measured with the lamp of a light sensor on: it takes at most 6. */
    const val LAMP_MILLISECONDS = 10

    /** The tones of `beep` and `buzz`, in hertz and milliseconds. */
    const val BEEP_FREQUENCY = 600
    const val BEEP_MILLISECONDS = 200
    const val BUZZ_FREQUENCY = 100
    const val BUZZ_MILLISECONDS = 500

    /** The max number of elements of all lists in use, with one more for each: what 48 KB have room for. */
    const val LIST_WORDS = 12_000

    fun speedOf(power: Int): Int = if (power == 0) SLOWEST_SPEED else power * SPEED_OF_POWER
}
