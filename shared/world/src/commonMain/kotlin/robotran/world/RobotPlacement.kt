package robotran.world

import robotran.world.geometry.Pose

/**
 * A robot in a world.
 *
 * @property name such as `red`; unique in the world.
 * @property start its pose at the start of a session.
 * @property ports the sensors on the input ports 1, 2 and 3; on a port with two, the one with the lower raw value wins,
 * as on a real brick.
 * @property lightFacing the direction of its light sensor; null if the pupil may choose it, see `RobotLoad`, with down
 * as the default.
 * @property beacon the brightness of a lamp on top of it, like a [Lamp] that shines all round; 0 for none.
 * @property program its default program in Robolang; null if it has none.
 */
data class RobotPlacement(
    val start: Pose,
    val name: String = "yellow",
    val colour: RobotColour = RobotColour.YELLOW,
    val ports: List<List<PortSensor>> = PENBOT_PORTS,
    val lightFacing: LightFacing? = null,
    val beacon: Double = 0.0,
    val program: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
) {
    companion object {
        /** Bumpers on 1 and 3, the light sensor on 2. */
        val PENBOT_PORTS =
            listOf(listOf(PortSensor.LEFT_BUMPER), listOf(PortSensor.LIGHT), listOf(PortSensor.RIGHT_BUMPER))
    }
}

/** The colour of a robot's brick, to tell robots apart. */
enum class RobotColour { YELLOW, RED, BLUE, GREEN, ORANGE, PURPLE, WHITE, BLACK }

/** The direction of a light sensor. */
enum class LightFacing { DOWN, FORWARD }

/** A sensor that can be connected to an input port. */
enum class PortSensor {
    LEFT_BUMPER,
    RIGHT_BUMPER,

    /** A touch sensor that the user presses. */
    TOUCH,
    LIGHT,

    /** A rotation sensor on the axle of a wheel: sixteen counts a turn, forwards positive. */
    LEFT_ROTATION,
    RIGHT_ROTATION,
    TEMPERATURE,
}
