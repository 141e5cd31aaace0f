package robotran.world

/** What an ultrasonic sensor hears. Angles are in degrees, lengths in centimetres. */
object Sonar {
    /** Half the angle of its beam, and the angle between two of the rays of which the model makes it. */
    const val BEAM = 20.0
    const val RAY_STEP = 2.5

    /** The angle from square at which a smooth surface is a mirror that sends the sound elsewhere. */
    const val MIRROR = 50.0

    /** An edge or a round thing answers within this angle of the middle, whatever its direction. */
    const val EDGE_BEAM = 12.0

    /** The farthest distance that the sensor can tell, and that from which a real one hears an echo. */
    const val FARTHEST = 254.0
    const val REAL_FARTHEST = 200.0

    /** From here on, a real sensor hears echoes more and more seldom. */
    const val SURE = 160.0

    /** The nearest distance that it tells, and the one below which a real one is not reliable. */
    const val NEAREST = 3.0
    const val TOO_CLOSE = 6.0

    /** Up to the first distance a real sensor reads too far; from the second on it does not. */
    const val NEAR = 22.0
    const val NEAR_END = 25.0

    /** Blocks that do not slide better than this are soft, like cloth, and answer up to a shorter distance. */
    const val SOFT_FRICTION = 0.6
    const val SOFT_FARTHEST = 150.0

    /**
     * Two sensors that look at each other within this angle, and ping at most so many milliseconds apart, disturb each
     * other.
     */
    const val CROSSTALK_BEAM = 25.0
    const val CROSSTALK_MILLISECONDS = 12
}
