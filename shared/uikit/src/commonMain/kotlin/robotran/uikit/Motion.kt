package robotran.uikit

/**
 * How long movements take, in milliseconds. Movement shows where something went or what to touch; with less motion
 * ([LocalLessMotion]) there is none. Nothing repeats for longer than [PULSES] pulses but the robot of the welcome.
 */
object Motion {
    /** Something opens, closes or moves. */
    const val MOVE = 150

    /** A ring around the recommended button, from its edge until it is gone. */
    const val PULSE = 1_400

    /** The number of rings. */
    const val PULSES = 5

    /** A robot dances after the goals are met. */
    const val DANCE = 2_400
}
