package robotran.ui.program.editor

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.gestures.calculateZoom
import androidx.compose.foundation.gestures.waitForUpOrCancellation
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventTimeoutCancellationException
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.unit.dp
import robotran.uikit.*
import kotlin.math.abs
import kotlin.math.pow

/** Touch and mouse input of an editor. */
internal interface EditorTouch {
    /** A press anywhere in the editor, before any other event. */
    fun pressed(byFinger: Boolean) = Unit

    /** [times] taps or clicks in a row at a position, by touch if [byFinger]. */
    fun tapped(position: Offset, times: Int, selecting: Boolean, byFinger: Boolean)

    /** A long press. */
    fun longPressed(position: Offset)

    /** Selects from the start of the drag to [position]. */
    fun draggedTo(position: Offset)

    /** Scales the font size by [factor]. */
    fun zoomed(factor: Float)
}

/** Sends touch and mouse events to [touch]. Touch drags scroll and are handled elsewhere. */
internal suspend fun PointerInputScope.listenFor(touch: EditorTouch) {
    var lastTap = 0L
    var lastPlace = Offset.Zero
    var taps = 0
    awaitEachGesture {
        val down = awaitFirstDown()
        val near = abs(down.position.x - lastPlace.x) < NEAR.toPx() && abs(down.position.y - lastPlace.y) < NEAR.toPx()
        val again = down.uptimeMillis - lastTap < viewConfiguration.doubleTapTimeoutMillis && near
        taps = if (again) taps % MAX_TAPS + 1 else 1
        lastTap = down.uptimeMillis
        lastPlace = down.position
        if (down.type == PointerType.Mouse) mouse(down, taps, touch) else finger(down, taps, touch)
    }
}

private suspend fun AwaitPointerEventScope.mouse(down: PointerInputChange, taps: Int, touch: EditorTouch) {
    touch.tapped(down.position, taps, currentEvent.keyboardModifiers.isShiftPressed, byFinger = false)
    down.consume()
    while (true) {
        val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: return
        if (!change.pressed) return
        if (change.position != change.previousPosition) touch.draggedTo(change.position)
        change.consume()
    }
}

private suspend fun AwaitPointerEventScope.finger(down: PointerInputChange, taps: Int, touch: EditorTouch) {
    try {
        val up = withTimeout(viewConfiguration.longPressTimeoutMillis) { waitForUpOrCancellation() } ?: return
        up.consume()
        touch.tapped(down.position, taps, selecting = false, byFinger = true)
    } catch (_: PointerEventTimeoutCancellationException) {
        touch.longPressed(down.position)
        while (true) {
            val change = awaitPointerEvent().changes.firstOrNull { it.id == down.id } ?: return
            if (change.position != change.previousPosition) touch.draggedTo(change.position)
            change.consume()
            if (!change.pressed) return
        }
    }
}

/** Zooms with two fingers or Ctrl and the mouse wheel; reports every press first. */
internal suspend fun PointerInputScope.listenForZoom(touch: EditorTouch) = awaitPointerEventScope {
    while (true) {
        val event = awaitPointerEvent(PointerEventPass.Initial)
        if (event.type == PointerEventType.Press) touch.pressed(event.changes.none { it.type == PointerType.Mouse })
        if (event.type == PointerEventType.Scroll && event.keyboardModifiers.isCtrlPressed) {
            val turned = event.wheelNotches(density).coerceIn(-1f, 1f)
            if (turned != 0f) touch.zoomed(WHEEL.pow(-turned))
            event.changes.forEach { it.consume() }
        } else if (event.changes.count { it.pressed } > 1) {
            val zoom = event.calculateZoom()
            if (zoom != 1f) touch.zoomed(zoom)
            event.changes.forEach { it.consume() }
        }
    }
}

private val NEAR = 24.dp
private const val MAX_TAPS = 3
private const val WHEEL = 1.08f
