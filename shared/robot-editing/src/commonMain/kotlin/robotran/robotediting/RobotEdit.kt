package robotran.robotediting

import robotran.editing.CommonEdits
import robotran.world.RobotDescription
import robotran.world.geometry.Point

/** A change of a robot by the user. Places are on the robot, in centimetres: x forwards, y to the left. */
sealed interface RobotEdit {
    /** null chooses nothing. */
    data class Choose(val element: RobotElement?) : RobotEdit

    data class ChooseNext(val backwards: Boolean = false) : RobotEdit

    // Dragging.

    data class StartDrag(val handle: RobotHandle, val at: Point) : RobotEdit

    data class DragTo(val at: Point) : RobotEdit

    data object Drop : RobotEdit

    /** Ends the drag and restores the robot. */
    data object CancelDrag : RobotEdit

    // Changes of the chosen element.

    data class Nudge(val x: Double, val y: Double) : RobotEdit

    data class TurnBy(val degrees: Double) : RobotEdit

    data object Remove : RobotEdit

    /** @property port null to plug the chosen thing out. */
    data class SetPort(val port: Int?) : RobotEdit

    /** Adds a corner in the middle between the chosen one and the next. */
    data object AddCorner : RobotEdit

    // Other changes.

    /** @property at null for its usual place. */
    data class Add(val item: RobotItem, val at: Point? = null) : RobotEdit

    /**
     * Changes figures; they are brought into their ranges and rounded as in a file.
     *
     * @property what what is changed, such as "mass": changes of the same figure are one undo step, up to a
     * [FinishChange]; null for a step of its own.
     */
    data class Change(val robot: RobotDescription, val what: String? = null) : RobotEdit

    /** Puts the wheels right by what was measured; changes of it are one undo step, up to a [FinishChange]. */
    data class Measure(val measured: Measured) : RobotEdit

    /** Builds another robot. */
    data class Replace(val robot: RobotDescription) : RobotEdit

    /** Ends a change by typing or with a slider; the next one is a separate undo step. */
    data object FinishChange : RobotEdit

    data object Undo : RobotEdit

    data object Redo : RobotEdit

    companion object {
        val COMMON: CommonEdits<RobotEdit> = CommonEdits(Undo, Redo, FinishChange, Drop, CancelDrag)
    }
}
