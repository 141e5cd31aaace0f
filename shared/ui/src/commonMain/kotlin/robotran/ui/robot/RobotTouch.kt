package robotran.ui.robot

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.gestures.calculateCentroid
import androidx.compose.foundation.gestures.calculatePan
import androidx.compose.foundation.gestures.calculateZoom
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.changedToUp
import androidx.compose.ui.input.pointer.positionChanged
import robotran.robotediting.RobotEdit
import robotran.robotediting.RobotElement
import robotran.robotediting.RobotHandle
import robotran.robotediting.elementsAt

/** Handles touch and mouse input on the plan. [scope] returns the current robot. */
internal suspend fun PointerInputScope.buildByTouch(view: PlanView, scope: () -> RobotScope, onTouched: () -> Unit) =
    awaitEachGesture {
        val down = awaitFirstDown()
        onTouched()
        with(PlanFinger(view, scope, density)) { follow(down.position) }
    }

/** The mouse wheel zooms at the pointer. */
internal suspend fun PointerInputScope.zoomPlanByWheel(view: PlanView) = awaitPointerEventScope {
    while (true) {
        val event = awaitPointerEvent()
        if (event.type != PointerEventType.Scroll) continue
        val change = event.changes.first()
        view.zoomBy(if (change.scrollDelta.y < 0) WHEEL_ZOOM else 1 / WHEEL_ZOOM, change.position)
        change.consume()
    }
}

/** One finger from press to release. */
private class PlanFinger(private val view: PlanView, private val scope: () -> RobotScope, density: Float) {
    private val transform = view.transform
    private val handleReach = HANDLE * density
    private val reach = transform.toCentimetres(FINGER * density)

    suspend fun AwaitPointerEventScope.follow(down: Offset) {
        val editing = scope().editing
        val handle = placedHandles(editing, transform, density)
            .filter { (it.second - down).getDistance() <= handleReach }
            .minByOrNull { (it.second - down).getDistance() }?.first
        val there = editing.robot.elementsAt(transform.toRobot(down), reach)
        val chosen = editing.chosen?.let { if (it is RobotElement.Corner) RobotElement.Chassis else it }
        val isOnChosen = chosen in there
        when {
            handle != null -> drag(down, there, handle, choosing = null)
            chosen != null && isOnChosen -> drag(down, there, RobotHandle.Body(chosen), choosing = null)
            there.isEmpty() || !there.first().isLoose -> push(down, there)
            else -> drag(down, there, RobotHandle.Body(there.first()), choosing = there.first())
        }
    }

    /** What a finger moves without choosing it first; the rest of the robot stays where it is. */
    private val RobotElement.isLoose: Boolean get() = this is RobotElement.Part || this is RobotElement.Caster

    private suspend fun AwaitPointerEventScope.drag(
        down: Offset,
        there: List<RobotElement>,
        handle: RobotHandle,
        choosing: RobotElement?,
    ) {
        var held = false
        val end = moves(down) { place ->
            if (!held) {
                choosing?.let { scope().make(RobotEdit.Choose(it)) }
                (handle as? RobotHandle.Corner)?.let { scope().make(RobotEdit.Choose(RobotElement.Corner(it.number))) }
                scope().make(RobotEdit.StartDrag(handle, transform.toRobot(down)))
            }
            held = true
            scope().make(RobotEdit.DragTo(transform.toRobot(place)))
        }
        when {
            end == End.SECOND_FINGER && held -> scope().make(RobotEdit.CancelDrag)
            held -> scope().make(RobotEdit.Drop)

            end == End.UP && handle is RobotHandle.Corner -> scope().make(
                RobotEdit.Choose(RobotElement.Corner(handle.number)),
            )

            end == End.UP && handle is RobotHandle.Body -> tap(there)
        }
    }

    private suspend fun AwaitPointerEventScope.push(down: Offset, there: List<RobotElement>) {
        var last = down
        var moved = false
        val end = moves(down) { place ->
            moved = true
            view.pushBy(place - last)
            last = place
        }
        if (!moved && end == End.UP) tap(there)
    }

    /** Chooses what is there, or the one below it if that is already chosen. */
    private fun tap(there: List<RobotElement>) {
        val chosen = scope().editing.chosen.let { if (it is RobotElement.Corner) RobotElement.Chassis else it }
        val now = there.indexOf(chosen)
        scope().make(RobotEdit.Choose(if (there.isEmpty()) null else there[(now + 1) % there.size]))
    }

    private enum class End { UP, SECOND_FINGER }

    /** Passes positions to [onMove] once the finger has moved. A second finger starts a pinch and cancels all else. */
    private suspend fun AwaitPointerEventScope.moves(down: Offset, onMove: (Offset) -> Unit): End {
        var moving = false
        while (true) {
            val event = awaitPointerEvent()
            if (event.changes.count { it.pressed } > 1) {
                pinch()
                return End.SECOND_FINGER
            }
            val change = event.changes.first()
            if (change.changedToUp() || !change.pressed) {
                change.consume()
                return End.UP
            }
            if (!change.positionChanged()) continue
            moving = moving || (change.position - down).getDistance() > viewConfiguration.touchSlop
            if (moving) onMove(change.position)
            change.consume()
        }
    }

    private suspend fun AwaitPointerEventScope.pinch() {
        while (true) {
            val event = awaitPointerEvent()
            if (event.changes.none { it.pressed }) return
            if (event.changes.count { it.pressed } > 1) {
                view.pushBy(event.calculatePan())
                view.zoomBy(event.calculateZoom(), event.calculateCentroid())
            }
            event.changes.forEach { it.consume() }
        }
    }
}

private const val WHEEL_ZOOM = 1.2f

/** The tolerance of a finger for elements and for handles, in dp. */
private const val FINGER = 12f
private const val HANDLE = 24f
