package robotran.world

/**
 * The light model of the light sensor. The unit is chosen for a simple [rawValue]: an amount of 1 lowers the raw value
 * by half of its span. The constants match what builders report: white paper about 700 (50 %), black about 800 (35 %),
 * a dim room about 850, a torch close by about 400.
 */
object Light {
    /** The ambient light of a dim room; daylight is about 2. */
    const val DIM_ROOM = 0.3

    /**
     * The light of a [Lamp] of brightness 1 at [LAMP_DISTANCE] centimetres; it falls with the square of the distance
     * and is constant below [NEAREST].
     */
    const val LAMP = 6.0
    const val LAMP_DISTANCE = 10.0
    const val NEAREST = 4.0

    /** The light of the sensor's own lamp that perfectly white paper reflects. */
    const val OWN_LAMP = 0.44

    /** The light of the sensor's lamp that leaks into the sensor when it looks at the paper. */
    const val STRAY = 0.41

    /** The part of the ambient light that gets under the robot. */
    const val UNDER_ROBOT = 0.05

    /**
     * Reflectance of walls, barriers, blocks and robots for the sensor's lamp when it looks ahead, and the distance at
     * which half of it is lost.
     */
    const val OBJECT_REFLECTANCE = 0.6
    const val ECHO_DISTANCE = 4.0

    /** Max distance of reflections, in centimetres. */
    const val MAX_ECHO_DISTANCE = 25.0

    /** Reflectance of paper, ink, and the floor beside the paper. */
    const val PAPER = 0.9
    const val INK = 0.12
    const val FLOOR = 0.25

    private const val DARK = 1023
    private const val SPAN = 723.0

    /** The sensor's raw value before rounding: 1023 in the dark, never below 300. */
    fun rawValue(amount: Double): Double = DARK - SPAN * amount / (amount + 1)
}
