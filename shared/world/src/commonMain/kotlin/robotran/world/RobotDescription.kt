package robotran.world

import robotran.brick.controls.MotorPort
import robotran.brick.kind.BrickKind
import robotran.world.geometry.Point

/**
 * The construction of a robot. Lengths are in centimetres, angles in degrees counter-clockwise, masses in kilograms.
 * Points are relative to the midpoint between the drive wheels: x forwards, y to the left. `docs/robots.md` describes
 * the file format; [robotran.world.robot.robotErrors] says what makes a robot impossible.
 *
 * @property title its name for people.
 * @property casters where casters or skids support it; the one on the side of the mass bears the rest of the load.
 * @property pen null if it has none; the tip is at the origin.
 * @property parts its bumpers and sensors. Entries that differ only in their ports are one thing with several cables.
 * @property buggy what its micro:bit is plugged into; null for other bricks.
 * @property base the name of the ready robot that its file is like, see [ReadyRobots]; null for the penbot of its brick.
 * @property unknown unknown fields of the file.
 */
data class RobotDescription(
    val title: String,
    val brick: BrickKind,
    val chassis: Chassis,
    val drive: Drive,
    val casters: List<Point>,
    val pen: PenMount?,
    val brickAt: BrickMount,
    val parts: List<RobotPart>,
    val buggy: BuggyMount? = null,
    val base: String? = null,
    val unknown: UnknownFields = UnknownFields.NONE,
)

/** The ports that motors are on: those of the wheels, the pen and what turns sensors. */
val RobotDescription.pluggedMotors: Set<MotorPort>
    get() = setOfNotNull(drive.left, drive.right, pen?.motor) + parts.mapNotNull { (it as? SensorPart)?.turret }

/**
 * What the wheels, the brick and the parts are mounted on.
 *
 * @property outline three or more corners seen from above, in either direction; the edges do not cross.
 * @property height of its upper side over the floor.
 * @property mass of the whole robot.
 * @property massAt the centre of mass; its y is 0.
 */
data class Chassis(val outline: List<Point>, val height: Double, val mass: Double, val massAt: Point)

/**
 * The two drive wheels and their motors.
 *
 * @property track between the middles of the tyres.
 * @property gear turns of the motor per turn of the wheel.
 * @property reversed whether the motors must run backwards to drive forwards.
 * @property tyreFriction Coulomb coefficient of the tyres on paper.
 */
data class Drive(
    val wheelDiameter: Double,
    val wheelWidth: Double,
    val track: Double,
    val gear: Double,
    val left: MotorPort,
    val right: MotorPort,
    val reversed: Boolean = false,
    val tyreFriction: Double = 1.0,
)

/** A pen that a motor lowers when it runs forwards and lifts when it runs backwards. */
data class PenMount(val motor: MotorPort)

/**
 * Where the brick is mounted; matters only for pictures.
 *
 * @property turned whether its display is towards the back.
 */
data class BrickMount(val at: Point, val turned: Boolean = false)
