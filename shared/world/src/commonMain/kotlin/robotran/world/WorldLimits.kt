package robotran.world

/**
 * The limits of a world, so that no world can fill the memory or make a step too slow. Lengths are in centimetres,
 * angles in degrees.
 */
object WorldLimits {
    const val MAXIMUM_TITLE_CHARACTERS = 100

    /** For the task and the goals' texts: a few sentences. */
    const val MAXIMUM_SENTENCE_CHARACTERS = 500
    const val MAXIMUM_TASK_CHARACTERS = 1000
    const val MAXIMUM_NAME_CHARACTERS = 40

    /** Room for the robot to turn on the spot. */
    const val MINIMUM_PAPER_SIDE = 20.0

    /** A floor of ten metres, more than any classroom's table. */
    const val MAXIMUM_PAPER_SIDE = 1000.0

    /** Objects may be beside the paper, but not out of sight of it. */
    const val MINIMUM_COORDINATE = -1000.0
    const val MAXIMUM_COORDINATE = 2000.0
    const val MAXIMUM_ANGLE = 360.0

    /** For walls, barriers, blocks, circles and lines. */
    const val MINIMUM_THICKNESS = 0.1
    const val MAXIMUM_WALL_THICKNESS = 100.0
    const val MAXIMUM_SHAPE_SIDE = 2000.0

    const val MAXIMUM_WALLS = 200
    const val MAXIMUM_BARRIERS = 400
    const val MAXIMUM_BLOCKS = 100
    const val MAXIMUM_MARKS = 500
    const val MAXIMUM_LAMPS = 20

    /** One brick each. */
    const val MAXIMUM_ROBOTS = 8
    const val MAXIMUM_SENSORS_PER_PORT = 2

    /** Of a polygon; its check compares each pair of edges. */
    const val MAXIMUM_CORNERS = 100

    /** Min area of a polygon, in square centimetres. */
    const val MINIMUM_AREA = 0.01

    /** For a line or a stroke of the template. */
    const val MAXIMUM_LINE_POINTS = 2000
    const val MAXIMUM_STROKES = 500

    /** For all polygons, lines and strokes together. */
    const val MAXIMUM_POINTS = 20_000
    const val MAXIMUM_MAP_SIDE = 1000

    /** For all grey maps together. */
    const val MAXIMUM_MAP_CELLS = 250_000
    const val MINIMUM_CELL = 0.01
    const val MAXIMUM_CELL = 100.0

    /** In kilograms. */
    const val MINIMUM_MASS = 0.001
    const val MAXIMUM_MASS = 100.0
    const val MAXIMUM_FRICTION = 10.0

    /** For lamps, beacons and the ambient light, in the units of [Light]. */
    const val MAXIMUM_BRIGHTNESS = 100.0
    const val MINIMUM_CONE = 1.0

    /** The range of a brick's temperature sensor. */
    const val MINIMUM_TEMPERATURE = -20.0
    const val MAXIMUM_TEMPERATURE = 50.0

    const val MAXIMUM_PROGRAM_LINES = 1000
    const val MAXIMUM_PROGRAM_LINE_CHARACTERS = 200

    /** Including nested goals. */
    const val MAXIMUM_GOALS = 50

    /** Max nesting depth of goals. */
    const val MAXIMUM_GOAL_DEPTH = 4

    /** One hour of virtual time. */
    const val MAXIMUM_SECONDS = 3600
    const val MAXIMUM_INK = 100_000.0
    const val MINIMUM_LAPS = 0.1
    const val MAXIMUM_LAPS = 100.0
    const val MAXIMUM_TOLERANCE = 100.0
    const val MAXIMUM_EXCESS = 100.0

    /** A line of the display of an NXT. */
    const val MAXIMUM_DISPLAY_CHARACTERS = 16

    const val MAXIMUM_SOUNDS = 1000

    /** The range of a brick's loudspeaker, in hertz. */
    const val LOWEST_TONE = 31
    const val HIGHEST_TONE = 20_000

    internal val COORDINATES = MINIMUM_COORDINATE..MAXIMUM_COORDINATE
    internal val ANGLES = -MAXIMUM_ANGLE..MAXIMUM_ANGLE
    internal val SHAPE_SIDES = MINIMUM_THICKNESS..MAXIMUM_SHAPE_SIDE
    internal val SECONDS = 1..MAXIMUM_SECONDS
}
