package robotran.ui.editing

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

/** Handles touch and mouse input on a canvas: [follow] follows one finger from where it is pressed. */
internal suspend fun PointerInputScope.editByTouch(
    onTouched: () -> Unit,
    follow: suspend AwaitPointerEventScope.(Offset) -> Unit,
) = awaitEachGesture {
    val down = awaitFirstDown()
    onTouched()
    follow(down.position)
}

/** The mouse wheel zooms at the pointer. */
internal suspend fun PointerInputScope.zoomByWheel(view: EditorView) = awaitPointerEventScope {
    while (true) {
        val event = awaitPointerEvent()
        if (event.type != PointerEventType.Scroll) continue
        val change = event.changes.first()
        view.zoomBy(if (change.scrollDelta.y < 0) WHEEL_ZOOM else 1 / WHEEL_ZOOM, change.position)
        change.consume()
    }
}

internal enum class TouchEnd { UP, SECOND_FINGER }

/** Passes positions to [onMove] once the finger has moved. A second finger starts a pinch and cancels all else. */
internal suspend fun AwaitPointerEventScope.moves(view: EditorView, down: Offset, onMove: (Offset) -> Unit): TouchEnd {
    var moving = false
    while (true) {
        val event = awaitPointerEvent()
        if (event.changes.count { it.pressed } > 1) {
            pinch(view)
            return TouchEnd.SECOND_FINGER
        }
        val change = event.changes.first()
        if (change.changedToUp() || !change.pressed) {
            change.consume()
            return TouchEnd.UP
        }
        if (!change.positionChanged()) continue
        moving = moving || (change.position - down).getDistance() > viewConfiguration.touchSlop
        if (moving) onMove(change.position)
        change.consume()
    }
}

/**
 * Drags what [take] takes once the finger moves; [move] is the edit that brings it to a place. Returns whether the
 * finger has only tapped.
 */
internal suspend fun <T : Any> AwaitPointerEventScope.drag(
    view: EditorView,
    down: Offset,
    scope: () -> EditScope<T>,
    take: () -> Unit,
    move: (Offset) -> T,
): Boolean {
    var held = false
    val end = moves(view, down) { place ->
        if (!held) take()
        held = true
        scope().make(move(place))
    }
    val edits = scope().edits
    if (held) scope().make(if (end == TouchEnd.SECOND_FINGER) edits.cancelDrag else edits.drop)
    return !held && end == TouchEnd.UP
}

/** Moves the canvas under the finger. Returns whether the finger has only tapped. */
internal suspend fun AwaitPointerEventScope.push(view: EditorView, down: Offset): Boolean {
    var last = down
    var moved = false
    val end = moves(view, down) { place ->
        moved = true
        view.pushBy(place - last)
        last = place
    }
    return !moved && end == TouchEnd.UP
}

private suspend fun AwaitPointerEventScope.pinch(view: EditorView) {
    while (true) {
        val event = awaitPointerEvent()
        if (event.changes.none { it.pressed }) return
        if (event.changes.count { it.pressed } > 1) {
            view.pushBy(event.calculatePan())
            view.zoomBy(event.calculateZoom().toDouble(), event.calculateCentroid())
        }
        event.changes.forEach { it.consume() }
    }
}

private const val WHEEL_ZOOM = 1.2

/** The tolerance of a finger for elements and for handles, in dp. */
internal const val FINGER_REACH = 12f
internal const val HANDLE_REACH = 24f
