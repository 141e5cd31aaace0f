package robotran.world

/**
 * How much light there is and what the light sensor makes of it. The unit is chosen so that [rawValue] is simple: an
 * amount of 1 brings the raw value halfway down. The figures are set so that the sensor measures what builders report:
 * white paper about 700 (50 %), black about 800 (35 %), a dim room about 850, a torch close by about 400.
 */
object Light {
    /** The light everywhere in a dim room; daylight is about 2. */
    const val DIM_ROOM = 0.3

    /**
     * What a [Lamp] of brightness 1 gives at [LAMP_DISTANCE] centimetres; it falls with the square of the distance, but
     * no further up than at [NEAREST].
     */
    const val LAMP = 6.0
    const val LAMP_DISTANCE = 10.0
    const val NEAREST = 4.0

    /** What comes back from perfectly white paper of the sensor's own lamp. */
    const val OWN_LAMP = 0.44

    /** What creeps from the sensor's lamp into it whatever it looks at, when it looks at the paper. */
    const val STRAY = 0.41

    /** The part of the light around that gets under the robot. */
    const val UNDER_ROBOT = 0.05

    /**
     * How much of the sensor's light the surfaces of walls, barriers, blocks and robots send back when it looks ahead,
     * and how close half of it is lost.
     */
    const val THINGS = 0.6
    const val ECHO_DISTANCE = 4.0

    /** Beyond this distance, in centimetres, nothing comes back. */
    const val FARTHEST_ECHO = 25.0

    /** What paper, ink, and the floor beside the paper send back of the light. */
    const val PAPER = 0.9
    const val INK = 0.12
    const val FLOOR = 0.25

    private const val DARK = 1023
    private const val SPAN = 723.0

    /** What the sensor measures, before it is rounded: 1023 in the dark, never below 300. */
    fun rawValue(amount: Double): Double = DARK - SPAN * amount / (amount + 1)
}
