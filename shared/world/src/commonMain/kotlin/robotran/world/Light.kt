package robotran.world

/**
 * How much light there is and what the light sensor makes of it. The unit is chosen so that [response] is simple: an amount of 1 brings the
 * raw value halfway down.
 */
object Light {
    /** The light everywhere in a dim room, in which a sensor that looks ahead measures about 850. */
    const val DIM_ROOM = 0.3
}
