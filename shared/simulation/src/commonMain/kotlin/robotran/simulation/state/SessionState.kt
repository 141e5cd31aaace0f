package robotran.simulation.state

import robotran.brick.program.RuntimeWarning
import robotran.brick.state.BrickState
import robotran.world.Light
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * The observable state of a session at one moment; immutable.
 *
 * @property milliseconds virtual time since the session began.
 * @property robots in the world's order.
 * @property blocks the translation and rotation of each block from its initial pose, in the world's order.
 * @property lamps the current state of the lamps, in the world's order.
 * @property ink what has been drawn so far.
 * @property goals the progress of the world's goals, in its order.
 * @property surroundings the current light and temperature.
 * @property trail the paths of the robots, with their pens down or up.
 */
data class SessionState(
    val milliseconds: Long,
    val robots: List<RobotSnapshot>,
    val blocks: List<Pose>,
    val lamps: List<LampState>,
    val ink: Ink,
    val goals: List<GoalProgress>,
    val surroundings: AmbientConditions = AmbientConditions(),
    val trail: List<TrailPiece> = emptyList(),
) {
    /** The first robot, the pupil's own. */
    private val first: RobotSnapshot get() = robots.first()

    /** The first robot's brick; the properties below are also the first robot's. */
    val brick: BrickState get() = first.brick
    val robot: RobotState get() = first.robot
    val bumps: Int get() = first.bumps
    val warnings: List<RuntimeWarning> get() = first.warnings
    val missingSensors: MissingSensors? get() = first.missingSensors
    val romCalls: Int get() = first.romCalls
}

/**
 * One robot at one moment.
 *
 * @property brick the observable state of its brick.
 * @property robot the pose and the parts of the penbot.
 * @property bumps number of times a bumper has touched something.
 * @property warnings warnings for the pupil about the current or last program, that of [missingSensors] first.
 * @property romCalls number of logged calls so far.
 * @property missingSensors what that program expects at the ports, but the robot does not have there; null for nothing.
 * @property bumpedAt virtual time of the latest of [bumps], in milliseconds since the session began; null before it.
 */
data class RobotSnapshot(
    val brick: BrickState,
    val robot: RobotState,
    val bumps: Int,
    val warnings: List<RuntimeWarning>,
    val romCalls: Int,
    val missingSensors: MissingSensors? = null,
    val bumpedAt: Long? = null,
)

/**
 * Conditions that are the same everywhere in a world.
 *
 * @property light the ambient light, in the units of [Light].
 * @property celsius the temperature.
 */
data class AmbientConditions(val light: Double = Light.DIM_ROOM, val celsius: Double = World.ROOM_TEMPERATURE)

/** The position of a lamp and whether it is on. */
data class LampState(val place: Point, val on: Boolean)

/**
 * A robot on the paper.
 *
 * @property pose the point between its wheels, and its heading.
 * @property leftWheelTurn rotation of the left wheel since the session began, in turns, forwards positive.
 * @property rightWheelTurn the same for the right wheel.
 * @property penDown whether the pen's tip touches the paper.
 * @property penDepth how far the pen is down: 0 at its upper end stop, 1 at its lower one. It touches the paper before.
 * @property leftBumperPressed whether the left bumper is pressed.
 * @property rightBumperPressed whether the right bumper is pressed.
 * @property touching the kinds that any part of it touches now.
 * @property touched the kinds that any part of it has touched since the session began.
 * @property pressed the indices of the pressed ones among the robot's bumpers, see [robotran.world.robot.bumpers].
 * @property motorDegrees degrees that the motors A, B and C of an NXT have turned since the session began; empty for an
 * RCX, whose motors nobody counts.
 * @property turret degrees by which a turret is turned to the left.
 */
data class RobotState(
    val pose: Pose,
    val leftWheelTurn: Double,
    val rightWheelTurn: Double,
    val penDown: Boolean,
    val leftBumperPressed: Boolean,
    val rightBumperPressed: Boolean,
    val touching: Set<TouchKind> = emptySet(),
    val touched: Set<TouchKind> = emptySet(),
    val penDepth: Double = if (penDown) 1.0 else 0.0,
    val pressed: Set<Int> = emptySet(),
    val motorDegrees: List<Double> = emptyList(),
    val turret: Double = 0.0,
)
