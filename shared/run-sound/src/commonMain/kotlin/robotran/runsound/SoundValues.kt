package robotran.runsound

/** Every number of the sounds of a run. Times are virtual and in milliseconds, lengths in centimetres. */
internal object SoundValues {
    /** A run is looked at this often, which is also how often goals are judged and runs recorded. */
    const val LOOK = 10L

    /**
     * Ticks in a turn of a wheel. A penbot at full power turns its wheels about once a second, so each wheel ticks 8
     * times a second: a rhythm that ears can still follow.
     */
    const val TICKS_PER_TURN = 8

    /** Short, so that it has no pitch to speak of; still as long as the shortest tone of a brick. */
    const val TICK_LENGTH = 10

    /** From the start of a tick until anything else may sound, so that ticks stay apart. */
    const val TICK_ROOM = 20L

    /** The left wheel is lower than the right one, for those who hear both on one loudspeaker. */
    const val TICK_LEFT = 700.0
    const val TICK_BOTH = 800.0
    const val TICK_RIGHT = 900.0

    /** A wheel that rolls backwards ticks an octave lower. */
    const val BACKWARDS = 0.5
    const val TICK_LOUDNESS = 0.5

    /** The distance ahead is told about three times a second: often enough to stop in time, seldom enough to count ticks. */
    const val TELLING = 300L
    const val TELLING_LENGTH = 60

    /** From the start of such a tone until anything else but a sign may sound. */
    const val TELLING_ROOM = 70L

    /** A robot that has moved and turned (in degrees) less than this since the last such tone tells nothing new. */
    const val MOVED = 0.5
    const val TURNED = 3.0

    /** The ground is looked at this often; at full speed the robot moves about a centimetre in that time. */
    const val GROUND_LOOK = 50L

    /** A saw and a square are louder than a sine of the same height. */
    const val SOFT_LOUDNESS = 0.8
    const val SHARP_LOUDNESS = 0.5

    /** Steps of distance grow with it, as the steps of what matters to a driver do. */
    val STEPS = doubleArrayOf(
        2.0,
        4.0,
        6.0,
        8.0,
        11.0,
        14.0,
        18.0,
        22.0,
        27.0,
        32.0,
        38.0,
        45.0,
        53.0,
        62.0,
        72.0,
        85.0,
        100.0,
    )

    /**
     * The pitch for each step of [STEPS], then that for nothing within them: C, D, E, G and A from C7 down to G3, which
     * sound well in any order. As figures, since platforms compute powers differently.
     */
    val PITCHES = doubleArrayOf(
        2093.0,
        1760.0,
        1568.0,
        1318.51,
        1174.66,
        1046.5,
        880.0,
        783.99,
        659.26,
        587.33,
        523.25,
        440.0,
        392.0,
        329.63,
        293.66,
        261.63,
        220.0,
        196.0,
    )

    /** A mark counts as seen if it reflects this much less than paper: a light sensor tells it from paper, too. */
    const val DARKER = 0.15

    /** A robot that pushes something loses and finds it again and again; that is one bump. */
    const val BUMP_PAUSE = 500L
}
