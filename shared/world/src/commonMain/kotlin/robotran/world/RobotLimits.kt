package robotran.world

/** The ranges of the figures of a [RobotDescription]. Lengths are in centimetres, masses in kilograms. */
object RobotLimits {
    const val MAXIMUM_TITLE_CHARACTERS = 40

    /** Of any coordinate on a robot. */
    val COORDINATES = -40.0..40.0
    val ANGLES = -360.0..360.0

    val CORNERS = 3..12
    val OUTLINE_SIDES = 4.0..60.0
    val HEIGHTS = 2.0..30.0
    val MASSES = 0.1..5.0

    val WHEEL_DIAMETERS = 2.0..10.0
    val WHEEL_WIDTHS = 0.5..6.0
    val TRACKS = 4.0..40.0
    val GEARS = 0.2..12.0
    val TYRE_FRICTIONS = 0.1..2.0

    const val MAXIMUM_CASTERS = 4
    const val MAXIMUM_PARTS = 12
    val BUMPER_WIDTHS = 1.0..30.0
    val BUMPER_DEPTHS = 0.5..4.0
    val SENSOR_HEIGHTS = 0.0..30.0

    /** Of a light or colour sensor that looks at the floor. */
    const val HIGHEST_OVER_FLOOR = 3.0

    /** Farthest distance of a sensor from the robot's box. */
    const val FARTHEST_SENSOR = 15.0

    /** Nearest distance of a caster ahead of the axle or behind it. */
    const val NEAREST_CASTER = 1.0

    /** With full power and fresh batteries, in centimetres a second: above that, it could pass through thin walls. */
    const val FASTEST = 60.0

    /** The physics tells so many of a body's shapes apart. */
    const val MAXIMUM_SHAPES = 16
}
