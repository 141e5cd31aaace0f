package robotran.ui.sheet

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.gestures.calculateCentroid
import androidx.compose.foundation.gestures.calculatePan
import androidx.compose.foundation.gestures.calculateZoom
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.input.pointer.positionChanged
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.dp
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.launch
import robotran.uikit.*
import kotlin.math.abs
import kotlin.math.pow

/** Touch, mouse and wheel on a sheet: see [SheetTouch]. */
internal suspend fun PointerInputScope.sheetGestures(look: SheetLook, touch: () -> SheetTouch?) = coroutineScope {
    launch { awaitPointerEventScope { while (true) turnWheel(awaitPointerEvent(), look, density) } }
    var lastTap: PointerInputChange? = null
    awaitEachGesture {
        val down = awaitFirstDown()
        val nothing = followFinger(down, look, touch)
        val before = lastTap
        val isSecond =
            nothing && before != null &&
                down.uptimeMillis - before.uptimeMillis < viewConfiguration.doubleTapTimeoutMillis &&
                (down.position - before.position).getDistance() < DOUBLE_TAP_DISTANCE.toPx()
        if (isSecond) look.zoom(DOUBLE_TAP_ZOOM, down.position)
        lastTap = down.takeIf { nothing && !isSecond }
    }
}

private fun turnWheel(event: PointerEvent, look: SheetLook, density: Float) {
    if (event.type != PointerEventType.Scroll) return
    val change = event.changes.first()
    val turned = event.wheelNotches(density)
    if (change.isConsumed || abs(turned) == 0f) return
    look.zoom(WHEEL_ZOOM.pow(-turned.coerceIn(-MAX_WHEEL, MAX_WHEEL).toDouble()), change.position)
    change.consume()
}

/** Handles a gesture from the first finger down to the last one up. Returns whether it was a tap on no element. */
private suspend fun AwaitPointerEventScope.followFinger(
    down: PointerInputChange,
    look: SheetLook,
    touch: () -> SheetTouch?,
): Boolean {
    val things = touch()
    val tolerance = look.transform.toCentimetres(toleranceOf(down.type))
    val start = look.transform.toCentimetres(down.position)
    var moved = Offset.Zero
    var taken = false
    var pushing = false
    try {
        while (true) {
            val event = awaitPointerEvent(PointerEventPass.Main)
            val finger = event.changes.firstOrNull { it.id == down.id }
            if (taken) {
                if (finger == null || finger.isConsumed || !finger.pressed) break
                things?.drag(look.transform.toCentimetres(finger.position))
                event.changes.forEach { if (it.positionChanged()) it.consume() }
                continue
            }
            if (event.changes.none { it.pressed }) {
                if (!pushing && finger != null && !finger.isConsumed) {
                    finger.consume()
                    return things?.tap(start, tolerance) != true
                }
                break
            }
            if (event.changes.count { it.pressed } > 1) {
                pushing = true
                pinch(event, look)
                continue
            }
            moved += event.calculatePan()
            if (!pushing && moved.getDistance() > viewConfiguration.touchSlop) {
                taken = things?.take(start, tolerance) == true
                pushing = !taken
                if (taken) things?.drag(look.transform.toCentimetres(down.position + moved))
                if (pushing) look.push(moved)
            } else if (pushing) {
                look.push(event.calculatePan())
            }
            if (taken || pushing) event.changes.forEach { if (it.positionChanged()) it.consume() }
        }
    } catch (cancelled: CancellationException) {
        if (taken) things?.giveUp()
        throw cancelled
    }
    if (taken) things?.letGo()
    return false
}

private fun pinch(event: PointerEvent, look: SheetLook) {
    val about = event.calculateCentroid(useCurrent = true)
    val zoom = event.calculateZoom()
    if (zoom != 1f && about != Offset.Unspecified) look.zoom(zoom.toDouble(), about)
    val pan = event.calculatePan()
    if (pan != Offset.Zero) look.push(pan)
    event.changes.forEach { if (it.positionChanged()) it.consume() }
}

/** How inaccurate a pointer of this [type] is, in pixels: a finger is about a centimetre wide, the mouse is exact. */
internal fun Density.toleranceOf(type: PointerType): Float =
    (if (type == PointerType.Mouse) MOUSE_TOLERANCE else FINGER_TOLERANCE).toPx()

private val FINGER_TOLERANCE = 20.dp
private val MOUSE_TOLERANCE = 6.dp
internal val DOUBLE_TAP_DISTANCE = 40.dp
internal const val DOUBLE_TAP_ZOOM = 2.0
internal const val WHEEL_ZOOM = 1.15
internal const val MAX_WHEEL = 5f
