package robotran.world

import robotran.world.geometry.Pose

/**
 * A robot in a world.
 *
 * @property name such as `red`; unique in the world.
 * @property start its pose at the start of a session.
 * @property description how it is built.
 * @property lightFacing the direction of its light sensors that have none of their own ([Facing.Free]); null if the
 * pupil may choose it, see `RobotProgramSet`, with down as the default.
 * @property beacon the brightness of a lamp on top of it, like a [Lamp] that shines all round; 0 for none.
 * @property program its default program in Robolang; null if it has none.
 * @property draft a robot on which somebody still works and that is impossible so far, see
 * [robotran.world.robot.robotErrors]; null if there is none. It is to replace [description].
 */
data class RobotPlacement(
    val start: Pose,
    val name: String = "yellow",
    val colour: RobotColour = RobotColour.YELLOW,
    val description: RobotDescription = ReadyRobots.RCX_PENBOT,
    val lightFacing: LightFacing? = null,
    val beacon: Double = 0.0,
    val program: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
    val draft: RobotDescription? = null,
) {
    /**
     * What is on each input port, as far as it is a [PortSensor]; on a port with two, the one with the lower raw value
     * wins, as on a real brick.
     */
    val ports: List<List<PortSensor>> = description.pluggedSensors

    /** The same robot with these sensors on its ports, see [withPlugged]. */
    fun withPorts(ports: List<List<PortSensor>>): RobotPlacement = copy(description = description.withPlugged(ports))

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

/** A sensor of the penbot that can be connected to an input port. */
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
