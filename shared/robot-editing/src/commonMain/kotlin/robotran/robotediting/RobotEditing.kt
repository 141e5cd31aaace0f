package robotran.robotediting

import robotran.language.history.History
import robotran.world.RobotDescription
import robotran.world.geometry.Point
import robotran.world.robot.RobotError
import robotran.world.robot.robotErrors

/**
 * A robot in the workbench, with the workbench's state. [after] creates the next state. All figures stay in their
 * ranges; the robot may still be impossible, see [errors].
 *
 * @property chosen the chosen element of [robot]; null for none.
 * @property gesture the current drag.
 * @property error why the last edit did nothing; null if it was not refused.
 * @property errors what is impossible about the robot.
 */
data class RobotEditing(
    val robot: RobotDescription,
    val chosen: RobotElement? = null,
    val history: History<RobotSnapshot> = History(),
    val gesture: RobotGesture? = null,
    val error: RobotEditError? = null,
    val errors: List<RobotError> = emptyList(),
) {
    val isPossible: Boolean get() = errors.isEmpty()

    internal val snapshot: RobotSnapshot get() = RobotSnapshot(robot, chosen)

    companion object {
        fun of(robot: RobotDescription) = RobotEditing(robot, errors = robotErrors(robot))
    }
}

/** The user drags [handle] from [from]; [before] is the state at the start. */
data class RobotGesture(val handle: RobotHandle, val from: Point, val before: RobotSnapshot)

/** Why an edit does nothing. */
enum class RobotEditError {
    /** The robot has as many bumpers and sensors as a description can have. */
    TOO_MANY_PARTS,
    TOO_MANY_CASTERS,
    TOO_MANY_CORNERS,

    /** A chassis needs three corners. */
    TOO_FEW_CORNERS,

    /** The same thing is there already. */
    SAME_THING,

    /** Wheels, brick, mass and chassis stay. */
    NEEDED,
}

/** The state that undo restores. */
data class RobotSnapshot(val robot: RobotDescription, val chosen: RobotElement?)
