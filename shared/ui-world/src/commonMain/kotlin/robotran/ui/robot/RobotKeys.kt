package robotran.ui.robot

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotEditing
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotSnapping
import robotran.robotediting.elements
import robotran.ui.editing.FINE_STEP
import robotran.ui.editing.editForCommand

/** The edit for a key on the plan, on which the front is up; null for none. */
internal fun robotEditForKey(event: KeyEvent, editing: RobotEditing): RobotEdit? {
    if (event.type != KeyEventType.KeyDown) return null
    if (event.isCtrlPressed || event.isMetaPressed) return editForCommand(event, RobotEdit.COMMON)
    val shift = event.isShiftPressed
    val step = if (shift) FINE_STEP else RobotSnapping.CENTIMETRES
    return when (event.key) {
        Key.Tab -> tabbed(editing, shift)
        Key.DirectionUp -> RobotEdit.Nudge(step, 0.0)
        Key.DirectionDown -> RobotEdit.Nudge(-step, 0.0)
        Key.DirectionLeft -> RobotEdit.Nudge(0.0, step)
        Key.DirectionRight -> RobotEdit.Nudge(0.0, -step)
        Key.R -> RobotEdit.TurnBy(if (shift) -RobotSnapping.DEGREES else RobotSnapping.DEGREES)
        Key.Delete, Key.Backspace -> RobotEdit.Remove
        Key.Escape -> escapedRobot(editing)
        else -> null
    }
}

/** The edit for Escape and Back in the workbench, one step at a time; null if they close it. */
fun escapedRobot(editing: RobotEditing): RobotEdit? = when {
    editing.gesture != null -> RobotEdit.CancelDrag
    editing.chosen is RobotElement.Corner -> RobotEdit.Choose(RobotElement.Chassis)
    editing.chosen != null -> RobotEdit.Choose(null)
    else -> null
}

/** After the last element the focus moves on from the plan. */
private fun tabbed(editing: RobotEditing, backwards: Boolean): RobotEdit? {
    val all = editing.robot.elements()
    val isAtEnd = editing.chosen == (if (backwards) all.first() else all.last()) ||
        (backwards && editing.chosen == null)
    return if (isAtEnd) null else RobotEdit.ChooseNext(backwards)
}
