package robotran.world

/** What a world may hold, so that none can fill the memory or take a step too long. Lengths are in centimetres. */
object WorldLimits {
    /** The length of a file; a thousand times that of the plain sheet. */
    const val MAXIMUM_CHARACTERS = 1_000_000

    /** How deep objects and lists may lie in one another; the format needs four levels, later ones a few more. */
    const val MAXIMUM_DEPTH = 32
    const val MAXIMUM_NAME_CHARACTERS = 100

    /** Room for the robot to turn on the spot. */
    const val MINIMUM_PAPER_SIDE = 20.0

    /** A floor of ten metres, more than any classroom's table. */
    const val MAXIMUM_PAPER_SIDE = 1000.0
    const val MAXIMUM_WALLS = 200
    const val MINIMUM_WALL_THICKNESS = 0.1
    const val MAXIMUM_WALL_THICKNESS = 100.0

    /** Walls may stand beside the paper, but not out of sight of it. */
    const val MINIMUM_COORDINATE = -1000.0
    const val MAXIMUM_COORDINATE = 2000.0
    const val MAXIMUM_HEADING = 360.0
}
