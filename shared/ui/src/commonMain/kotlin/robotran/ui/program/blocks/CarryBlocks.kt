package robotran.ui.program.blocks

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.PointerType

/**
 * Carries blocks: a mouse, or a finger on a grip, at once; a finger elsewhere after a long press, since otherwise it
 * scrolls. It sees events before the blocks do and consumes them only once it carries.
 */
internal suspend fun PointerInputScope.carryBlocks(dragging: BlockDragging) = awaitEachGesture {
    val down = awaitFirstDown(requireUnconsumed = false, pass = PointerEventPass.Initial)
    val isAtOnce = down.type == PointerType.Mouse || dragging.isGrip(down.position)
    val begins = if (isAtOnce) movesAway(down) else isHeld(down)
    if (!begins || !dragging.take(down.position)) return@awaitEachGesture
    while (true) {
        val change = changeOf(down) ?: break
        change.consume()
        if (!change.pressed) {
            dragging.drop()
            return@awaitEachGesture
        }
        dragging.moveTo(change.position)
    }
    dragging.cancel()
}

/** Waits until the pointer has left its first position; false if it goes up before. */
private suspend fun AwaitPointerEventScope.movesAway(down: PointerInputChange): Boolean {
    while (true) {
        val change = changeOf(down) ?: return false
        if (!change.pressed) return false
        val isAway = (change.position - down.position).getDistance() > viewConfiguration.touchSlop
        if (isAway) {
            change.consume()
            return true
        }
    }
}

/** Waits for a long press; false if the finger moves or goes up before. */
private suspend fun AwaitPointerEventScope.isHeld(down: PointerInputChange): Boolean =
    withTimeoutOrNull(viewConfiguration.longPressTimeoutMillis) { movesAwayOrUp(down) } == null

private suspend fun AwaitPointerEventScope.movesAwayOrUp(down: PointerInputChange) {
    while (true) {
        val change = changeOf(down) ?: return
        if (!change.pressed) return
        if ((change.position - down.position).getDistance() > viewConfiguration.touchSlop) return
    }
}

private suspend fun AwaitPointerEventScope.changeOf(down: PointerInputChange): PointerInputChange? =
    awaitPointerEvent(PointerEventPass.Initial).changes.firstOrNull { it.id == down.id }
