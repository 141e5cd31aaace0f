package robotran.world

import robotran.rom.BrickState
import robotran.rom.ProgramRemark

/**
 * Everything there is to see of a session at one moment; never changes once given out.
 *
 * @property milliseconds virtual time since the session began.
 * @property brick the brick as seen from outside.
 * @property robot where the penbot is and what its parts do.
 * @property ink what has been drawn so far.
 * @property bumps how often a bumper has touched something.
 * @property remarks what the program that runs or ran last has to say to its pupil.
 * @property romCalls how many ROM calls have been made.
 */
data class SessionState(
    val milliseconds: Long,
    val brick: BrickState,
    val robot: RobotState,
    val ink: Ink,
    val bumps: Int,
    val remarks: List<ProgramRemark>,
    val romCalls: Int,
)

/**
 * The penbot as it stands on the paper.
 *
 * @property pose where the point between its wheels is, and where it looks.
 * @property leftWheelTurn how far the left wheel has turned since the session began, in turns, forwards positive.
 * @property rightWheelTurn the same of the right wheel.
 * @property penDown whether the pen's tip touches the paper.
 * @property leftBumperPressed whether the left bumper is pushed in.
 * @property rightBumperPressed the same of the right bumper.
 */
data class RobotState(
    val pose: Pose,
    val leftWheelTurn: Double,
    val rightWheelTurn: Double,
    val penDown: Boolean,
    val leftBumperPressed: Boolean,
    val rightBumperPressed: Boolean,
)

/**
 * A place on the paper and a direction.
 *
 * @property x centimetres from the paper's lower left corner to the right.
 * @property y centimetres from there upwards.
 * @property heading degrees counter-clockwise from the x axis, above -180 and up to 180.
 */
data class Pose(
    val x: Double,
    val y: Double,
    val heading: Double,
)
