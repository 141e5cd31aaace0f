package robotran.ui.robot

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotHandle
import robotran.robotediting.elementsAt
import robotran.ui.editing.FINGER_REACH
import robotran.ui.editing.HANDLE_REACH
import robotran.ui.editing.drag
import robotran.ui.editing.nearest
import robotran.ui.editing.push

/** Follows one finger on the plan from press to release. [scope] returns the current robot. */
internal suspend fun AwaitPointerEventScope.buildByFinger(view: PlanView, scope: () -> RobotScope, down: Offset) =
    with(PlanFinger(view, scope, density)) { follow(down) }

private class PlanFinger(private val view: PlanView, private val scope: () -> RobotScope, private val density: Float) {
    private val transform = view.transform

    suspend fun AwaitPointerEventScope.follow(down: Offset) {
        val editing = scope().editing
        val handle = placedHandles(editing, transform, density).nearest(down, HANDLE_REACH * density)
        val reach = transform.toCentimetres(FINGER_REACH * density)
        val there = editing.robot.elementsAt(transform.toRobot(down), reach)
        val chosen = whole(editing.chosen)
        when {
            handle != null -> dragOrTap(down, there, handle, choosing = null)
            chosen != null && chosen in there -> dragOrTap(down, there, RobotHandle.Body(chosen), choosing = null)

            there.isNotEmpty() && there.first().isLoose -> {
                dragOrTap(down, there, RobotHandle.Body(there.first()), choosing = there.first())
            }

            push(view, down) -> tap(there)
        }
    }

    /** What a finger moves without choosing it first; the rest of the robot stays where it is. */
    private val RobotElement.isLoose: Boolean get() = this is RobotElement.Part || this is RobotElement.Caster

    /** The chassis for one of its corners. */
    private fun whole(element: RobotElement?) = if (element is RobotElement.Corner) RobotElement.Chassis else element

    private suspend fun AwaitPointerEventScope.dragOrTap(
        down: Offset,
        there: List<RobotElement>,
        handle: RobotHandle,
        choosing: RobotElement?,
    ) {
        val corner = (handle as? RobotHandle.Corner)?.let { RobotElement.Corner(it.number) }
        val take = {
            (choosing ?: corner)?.let { scope().make(RobotEdit.Choose(it)) }
            scope().make(RobotEdit.StartDrag(handle, transform.toRobot(down)))
        }
        val isTap = drag(view, down, scope, take) { RobotEdit.DragTo(transform.toRobot(it)) }
        when {
            !isTap -> {}
            corner != null -> scope().make(RobotEdit.Choose(corner))
            handle is RobotHandle.Body -> tap(there)
        }
    }

    /** Chooses what is there, or the one below it if that is already chosen. */
    private fun tap(there: List<RobotElement>) {
        val now = there.indexOf(whole(scope().editing.chosen))
        scope().make(RobotEdit.Choose(if (there.isEmpty()) null else there[(now + 1) % there.size]))
    }
}
