package robotran.world

import robotran.brick.controls.MotorPort
import robotran.brick.sensors.SensorKind
import robotran.world.geometry.Point

/** A bumper or a sensor of a [RobotDescription]. */
sealed interface RobotPart {
    /** The input port, from 1; null if it is plugged in nowhere. */
    val port: Int?
    val unknown: UnknownFields

    /** What it is for a program. */
    val kind: SensorKind

    fun on(port: Int?): RobotPart
}

/**
 * A bar that presses a touch sensor.
 *
 * @property at the middle of its outer edge.
 * @property width along that edge.
 * @property depth from that edge towards the robot.
 * @property direction in which it faces: 0 ahead, 90 to the left, 180 back.
 * @property side a name for it; null if it has none.
 */
data class BumperPart(
    override val port: Int?,
    val at: Point,
    val width: Double,
    val depth: Double = DEFAULT_DEPTH,
    val direction: Double = 0.0,
    val side: BumperSide? = null,
    override val unknown: UnknownFields = UnknownFields.NONE,
) : RobotPart {
    override val kind: SensorKind get() = SensorKind.TOUCH

    override fun on(port: Int?) = copy(port = port)

    companion object {
        const val DEFAULT_DEPTH = 1.2
    }
}

enum class BumperSide { LEFT, RIGHT }

/**
 * A sensor that looks at the world.
 *
 * @property sensor all kinds but [SensorKind.TOUCH] and [SensorKind.ROTATION], which have parts of their own.
 * @property at where its eye is.
 * @property height of its eye over the floor.
 * @property turret the motor that turns it; null if it is fixed.
 */
data class SensorPart(
    override val port: Int?,
    val sensor: SensorKind,
    val at: Point,
    val height: Double,
    val facing: Facing,
    val turret: MotorPort? = null,
    override val unknown: UnknownFields = UnknownFields.NONE,
) : RobotPart {
    init {
        require(sensor != SensorKind.TOUCH && sensor != SensorKind.ROTATION) { "$sensor has a part of its own." }
    }

    override val kind: SensorKind get() = sensor

    override fun on(port: Int?) = copy(port = port)
}

/** The direction of a sensor. */
sealed interface Facing {
    data object Down : Facing

    /** @property direction on the robot: 0 ahead, 90 to the left. */
    data class Ahead(val direction: Double) : Facing

    /** The pupil's choice, see [RobotPlacement.lightFacing]. */
    data object Free : Facing
}

/** A rotation sensor on the axle of a drive wheel, which counts forwards as positive. */
data class RotationPart(
    override val port: Int?,
    val wheel: BumperSide,
    override val unknown: UnknownFields = UnknownFields.NONE,
) : RobotPart {
    override val kind: SensorKind get() = SensorKind.ROTATION

    override fun on(port: Int?) = copy(port = port)
}

/** A touch sensor that only a finger presses. */
data class FingerTouchPart(override val port: Int?, override val unknown: UnknownFields = UnknownFields.NONE) :
    RobotPart {
    override val kind: SensorKind get() = SensorKind.TOUCH

    override fun on(port: Int?) = copy(port = port)
}

/** Whether the parts are the same thing, plugged in or not. */
fun RobotPart.isSameThing(other: RobotPart): Boolean = on(null) == other.on(null)
