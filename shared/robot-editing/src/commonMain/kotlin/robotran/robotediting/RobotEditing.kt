package robotran.robotediting

import robotran.editing.Editor
import robotran.editing.Gesture
import robotran.language.history.History
import robotran.world.RobotDescription
import robotran.world.robot.RobotError
import robotran.world.robot.robotErrors

/**
 * A robot in the workbench, with the workbench's state. [after] creates the next state. All figures stay in their
 * ranges; the robot may still be impossible, see [errors].
 *
 * @property chosen the chosen element of [robot]; null for none.
 * @property error why the last edit did nothing; null if it was not refused.
 * @property errors what is impossible about the robot.
 * @property measured what was measured since the wheels were chosen; null for nothing.
 */
data class RobotEditing(
    val robot: RobotDescription,
    val chosen: RobotElement? = null,
    override val history: History<RobotSnapshot> = History(),
    override val gesture: Gesture<RobotSnapshot, RobotHandle>? = null,
    val error: RobotEditError? = null,
    val errors: List<RobotError> = emptyList(),
    val measured: Measured? = null,
) : Editor<RobotSnapshot, RobotHandle, RobotEditing> {
    val isPossible: Boolean get() = errors.isEmpty()

    override val snapshot: RobotSnapshot get() = RobotSnapshot(robot, chosen)

    override fun isAsIn(snapshot: RobotSnapshot): Boolean = robot == snapshot.robot

    override fun released(history: History<RobotSnapshot>): RobotEditing = copy(gesture = null, history = history)

    override fun restored(snapshot: RobotSnapshot, history: History<RobotSnapshot>): RobotEditing = copy(
        robot = snapshot.robot,
        chosen = snapshot.chosen,
        history = history,
        gesture = null,
        errors = robotErrors(snapshot.robot),
    )

    companion object {
        fun of(robot: RobotDescription) = RobotEditing(robot, errors = robotErrors(robot))
    }
}

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
