package robotran.simulation.state

import robotran.rcxrom.program.RuntimeWarning
import robotran.rcxrom.state.BrickState
import robotran.world.Light
import robotran.world.TouchKind
import robotran.world.World
import robotran.world.geometry.Point
import robotran.world.geometry.Pose

/**
 * Everything there is to see of a session at one moment; never changes once given out.
 *
 * @property milliseconds virtual time since the session began.
 * @property robots as many as the world has, in its order.
 * @property blocks where the world's blocks are now, in its order: how far the origin of each has moved from where the
 * world has it, and turned.
 * @property lamps the world's lamps, in its order, as they stand and shine now.
 * @property ink what has been drawn so far.
 * @property goals how the world's goals stand, in its order.
 * @property surroundings light and warmth as they are now.
 * @property trail where the robots have driven, with their pens down or up.
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

    /** The first robot's brick, and likewise all below. */
    val brick: BrickState get() = first.brick
    val robot: RobotState get() = first.robot
    val bumps: Int get() = first.bumps
    val remarks: List<RuntimeWarning> get() = first.remarks
    val romCalls: Int get() = first.romCalls
}

/**
 * One robot at one moment.
 *
 * @property brick the brick as seen from outside.
 * @property robot where the penbot is and what its parts do.
 * @property bumps how often a bumper has touched something.
 * @property remarks what the program that runs or ran last has to say to its pupil.
 * @property romCalls how many ROM calls have been made.
 */
data class RobotSnapshot(
    val brick: BrickState,
    val robot: RobotState,
    val bumps: Int,
    val remarks: List<RuntimeWarning>,
    val romCalls: Int,
)

/**
 * What is the same everywhere in a world.
 *
 * @property light the light that is everywhere, in the units of [Light].
 * @property celsius how warm it is.
 */
data class AmbientConditions(val light: Double = Light.DIM_ROOM, val celsius: Double = World.ROOM_TEMPERATURE)

/** Where a lamp is now and whether it shines. */
data class LampState(val place: Point, val on: Boolean)

/**
 * The penbot as it stands on the paper.
 *
 * @property pose where the point between its wheels is, and where it looks.
 * @property leftWheelTurn how far the left wheel has turned since the session began, in turns, forwards positive.
 * @property rightWheelTurn the same of the right wheel.
 * @property penDown whether the pen's tip touches the paper.
 * @property leftBumperPressed whether the left bumper is pushed in.
 * @property rightBumperPressed the same of the right bumper.
 * @property touching what any part of it touches now.
 * @property touched what any part of it has touched since the session began.
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
)
