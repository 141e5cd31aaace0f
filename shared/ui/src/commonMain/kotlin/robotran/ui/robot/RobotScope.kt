package robotran.ui.robot

import androidx.compose.runtime.Immutable
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.withThing
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorkshopEvent
import robotran.world.RobotDescription
import robotran.world.RobotPart

/** What the parts of the workbench read, and how they send edits. */
@Immutable
internal class RobotScope(val editing: RobotEditing, private val onEvent: (WorkshopEvent) -> Unit) {
    val robot: RobotDescription get() = editing.robot

    fun make(edit: RobotEdit) = onEvent(RobotEditEvent.Edited(edit))

    /** Sends a part of a longer change of the figure [what]; [settle] ends it. */
    fun change(robot: RobotDescription, what: String) = make(RobotEdit.Change(robot, what))

    /** Sends a change as a step of its own. */
    fun changeAtOnce(robot: RobotDescription) {
        settle()
        make(RobotEdit.Change(robot))
    }

    /** Changes a bumper or sensor, unless that makes it the same as another one. */
    fun changePart(number: Int, what: String?, change: (RobotPart) -> RobotPart) {
        val changed = robot.withThing(number, change) ?: return
        if (what == null) changeAtOnce(changed) else change(changed, "$what $number")
    }

    fun settle() = make(RobotEdit.FinishChange)

    fun perform(event: RobotEditEvent) = onEvent(event)
}
