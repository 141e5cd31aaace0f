package robotran.ui.program.blocks

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.input.pointer.isShiftPressed

/** What a pointer can carry. Positions are in pixels from the upper left corner of what receives the touches. */
internal interface Carrier {
    /** Whether a finger at [position] carries at once, without a long press. */
    fun isGrip(position: Offset): Boolean

    /** Called for each pointer that goes down. */
    fun onDown(isShiftHeld: Boolean) = Unit

    /** Takes up what is at [position]; false if there is nothing. */
    fun take(position: Offset): Boolean

    fun moveTo(position: Offset)

    fun drop()

    /** Stops carrying; does nothing if nothing is carried. */
    fun cancel()
}

/**
 * Lets a pointer carry: a mouse, or a finger on a grip, at once; a finger elsewhere after a long press, since otherwise
 * it scrolls. It sees events before what is inside does, and consumes them only once it carries.
 */
internal suspend fun PointerInputScope.carry(carrier: Carrier) = awaitEachGesture {
    val down = awaitFirstDown(requireUnconsumed = false, pass = PointerEventPass.Initial)
    carrier.onDown(currentEvent.keyboardModifiers.isShiftPressed)
    val isAtOnce = down.type == PointerType.Mouse || carrier.isGrip(down.position)
    val begins = if (isAtOnce) movesAway(down) else isHeld(down)
    if (!begins || !carrier.take(down.position)) return@awaitEachGesture
    try {
        carryOn(down, carrier)
    } finally {
        // The gesture may be interrupted, and then nothing has been dropped.
        carrier.cancel()
    }
}

private suspend fun AwaitPointerEventScope.carryOn(down: PointerInputChange, carrier: Carrier) {
    while (true) {
        val change = changeOf(down) ?: return
        change.consume()
        if (!change.pressed) return carrier.drop()
        carrier.moveTo(change.position)
    }
}

/** Waits until the pointer has left its first position; false if it goes up before, or another finger comes down. */
private suspend fun AwaitPointerEventScope.movesAway(down: PointerInputChange): Boolean {
    while (true) {
        val change = changeOf(down) ?: return false
        if (!change.pressed || hasMoreFingers()) return false
        if (isAway(change, down)) {
            change.consume()
            return true
        }
    }
}

/** Waits for a long press; false if the finger moves or goes up before, or another one comes down. */
private suspend fun AwaitPointerEventScope.isHeld(down: PointerInputChange): Boolean =
    withTimeoutOrNull(viewConfiguration.longPressTimeoutMillis) { staysNot(down) } == null

private suspend fun AwaitPointerEventScope.staysNot(down: PointerInputChange) {
    while (true) {
        val change = changeOf(down) ?: return
        if (!change.pressed || isAway(change, down) || hasMoreFingers()) return
    }
}

private fun AwaitPointerEventScope.isAway(change: PointerInputChange, down: PointerInputChange): Boolean =
    (change.position - down.position).getDistance() > viewConfiguration.touchSlop

/** Two fingers zoom. */
private fun AwaitPointerEventScope.hasMoreFingers(): Boolean = currentEvent.changes.count { it.pressed } > 1

private suspend fun AwaitPointerEventScope.changeOf(down: PointerInputChange): PointerInputChange? =
    awaitPointerEvent(PointerEventPass.Initial).changes.firstOrNull { it.id == down.id }
