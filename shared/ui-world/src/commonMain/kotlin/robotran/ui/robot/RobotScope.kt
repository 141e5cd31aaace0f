package robotran.ui.robot

import androidx.compose.runtime.Immutable
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.ui.editing.EditScope
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorkshopEvent
import robotran.world.RobotDescription

/** What the parts of the workbench read, and how they send edits. */
@Immutable
internal class RobotScope(val editing: RobotEditing, onEvent: (WorkshopEvent) -> Unit) :
    EditScope<RobotEdit>(RobotEdit.COMMON, RobotEditEvent::Edited, onEvent) {
    val robot: RobotDescription get() = editing.robot
}
