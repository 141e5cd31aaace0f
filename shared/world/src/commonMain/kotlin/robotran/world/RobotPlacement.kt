package robotran.world

import robotran.world.geometry.Pose

/**
 * A robot as it is put into a world.
 *
 * @property name what people and goals know it by, such as `red`; no two in a world are alike.
 * @property start where it stands when a session begins.
 * @property ports what is plugged into the input ports 1, 2 and 3; on a port with two, the one with the lower raw value
 * wins, as on a real brick.
 * @property lightFacing where its light sensor looks; null if the pupil may turn it, see [RobotLoad], otherwise it
 * looks down.
 * @property beacon the brightness of a lamp on top of it, as of a [Lamp] that shines all round; 0 if it has none.
 * @property program what it runs if nobody gives it another, in Robolang; null if it waits for one.
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

/** What a robot's brick looks like, so that people can tell several apart. */
enum class RobotColour { YELLOW, RED, BLUE, GREEN, ORANGE, PURPLE, WHITE, BLACK }

/** Where a light sensor looks. */
enum class LightFacing { DOWN, FORWARD }

/** What can be plugged into an input port. */
enum class PortSensor {
    LEFT_BUMPER,
    RIGHT_BUMPER,

    /** A touch sensor that only a finger presses. */
    TOUCH,
    LIGHT,

    /** A rotation sensor on the axle of a wheel: sixteen counts a turn, forwards positive. */
    LEFT_ROTATION,
    RIGHT_ROTATION,
    TEMPERATURE,
}
