package robotran.hub.control

/** What the controllers of motors count with. */
internal object ControlConstants {
    /** How often the controllers work, milliseconds. */
    const val PERIOD = 5

    const val PERIOD_SECONDS = PERIOD / 1000.0

    /** Full power, percent. */
    const val FULL = 100.0

    /** What a motor needs to overcome its own friction, percent. */
    const val FRICTION = 13.4

    /** How long a motor takes to follow its power, seconds. */
    const val LAG = 0.04

    /** Percent of power for a degree that a motor of [REFERENCE_SPEED] is behind, as in Pybricks: 15.1 of 199 mNm. */
    const val STIFFNESS = 7.6

    /** Percent of power for a degree a second that it is too slow. Pybricks has 0.95 at most; less is calmer. */
    const val DAMPING = 0.6

    /** The free speed that [STIFFNESS] and [DAMPING] are for, degrees a second. */
    const val REFERENCE_SPEED = 1110.0

    /** Slower than this, degrees a second, a move can be over. */
    const val SPEED_TOLERANCE = 50.0

    /** How near the angle of a driving base's motors must be to the end of a move, degrees. */
    const val BASE_TOLERANCE = 25.0

    /** Slower than this, degrees a second, a driven motor may be stalled. */
    const val STALL_SPEED = 20.0

    /** So long it must be so, milliseconds. */
    const val STALL_MILLISECONDS = 200

    /** The time over which speeds are measured, milliseconds. */
    const val SPEED_WINDOW = 100
}
