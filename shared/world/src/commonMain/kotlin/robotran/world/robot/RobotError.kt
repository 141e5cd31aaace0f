package robotran.world.robot

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.brick.sensors.SensorKind

/** Why a robot is impossible; `RobotMessages` has a sentence for each. */
sealed interface RobotError {
    /** The index of the part in question; null if it is about another piece, see [piece]. */
    val part: Int? get() = null

    /** What the error is about. */
    val piece: RobotPiece

    /** A figure is outside of its range. */
    data class OutOfRange(
        override val piece: RobotPiece,
        val figure: RobotParameter,
        val range: ClosedRange<Double>,
        override val part: Int? = null,
    ) : RobotError

    /** Too many things are plugged into a port. */
    data class PortTaken(override val part: Int, val port: Int) : OfPart

    data class NoSuchPort(override val part: Int, val brick: BrickKind, val port: Int) : OfPart

    /** The brick has no port for that motor, or a sensor is there. */
    data class NoSuchMotor(override val piece: RobotPiece, val brick: BrickKind, val motor: MotorPort) : RobotError

    /** A brick of this kind cannot read the sensor. */
    data class UnreadableSensor(override val part: Int, val brick: BrickKind, val kind: SensorKind) : OfPart

    /** The same motor drives both wheels. */
    data class OneDriveMotor(val motor: MotorPort) : OfWheels

    /** The motor of the pen drives a wheel, too. */
    data class PenMotorTaken(val motor: MotorPort) : RobotError {
        override val piece: RobotPiece get() = RobotPiece.PEN
    }

    data object NoWheels : OfWheels

    /** The tyres are inside each other. */
    data object WheelsTooClose : OfWheels

    data object TooFast : OfWheels

    /** The mass is not between the axle and a caster. */
    data class TipsOver(val backwards: Boolean) : RobotError {
        override val piece: RobotPiece get() = RobotPiece.CASTERS
    }

    data object CasterOnAxle : RobotError {
        override val piece: RobotPiece get() = RobotPiece.CASTERS
    }

    data object OutlineCrosses : OfOutline

    data object OutlineTooSmall : OfOutline

    data object OutlineTooLarge : OfOutline

    data object TooManyCorners : OfOutline

    data object MassOutside : OfMass

    /** The mass is to the left or right of the middle line. */
    data object MassBesideMiddle : OfMass

    data class BumperInside(override val part: Int) : OfPart

    /** A sensor needs at least [lowest] centimetres between it and the floor. */
    data class SensorInFloor(override val part: Int, val kind: SensorKind, val lowest: Double) : OfPart

    /** A sensor that looks at the floor is higher than [highest] centimetres. */
    data class SensorTooHigh(override val part: Int, val kind: SensorKind, val highest: Double) : OfPart

    /** Only light and colour sensors can look down. */
    data class CannotLookDown(override val part: Int, val kind: SensorKind) : OfPart

    /** The robot itself is right in front of the sensor. */
    data class LooksIntoRobot(override val part: Int, val kind: SensorKind) : OfPart

    /** A part is [centimetres] away from the robot. */
    data class FarAway(override val part: Int, val kind: SensorKind, val centimetres: Int) : OfPart

    /** The motor of a turret does something else, too. */
    data class TurretMotorTaken(override val part: Int, val motor: MotorPort, val byPen: Boolean) : OfPart

    /** The brick cannot tell how far a motor has turned. */
    data class NoTurret(override val part: Int, val brick: BrickKind) : OfPart

    sealed interface OfPart : RobotError {
        override val piece: RobotPiece get() = RobotPiece.PART
    }

    sealed interface OfWheels : RobotError {
        override val piece: RobotPiece get() = RobotPiece.WHEELS
    }

    sealed interface OfOutline : RobotError {
        override val piece: RobotPiece get() = RobotPiece.OUTLINE
    }

    sealed interface OfMass : RobotError {
        override val piece: RobotPiece get() = RobotPiece.MASS
    }
}

/** The pieces of a robot that an error can be about. */
enum class RobotPiece { OUTLINE, HEIGHT, MASS, WHEELS, CASTERS, PEN, BRICK, PART, ALL }

/** The figures of a robot that have a range, see [robotran.world.RobotLimits]. */
enum class RobotParameter {
    COORDINATE,
    CORNERS,
    HEIGHT,
    MASS,
    WHEEL_WIDTH,
    TRACK,
    GEAR,
    TYRE_FRICTION,
    CASTERS,
    PARTS,
    BUMPER_WIDTH,
    BUMPER_DEPTH,
    SENSOR_HEIGHT,
    ANGLE,
}
