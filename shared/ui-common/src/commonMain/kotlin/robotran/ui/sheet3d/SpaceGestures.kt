package robotran.ui.sheet3d

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.gestures.calculateCentroid
import androidx.compose.foundation.gestures.calculateCentroidSize
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
import androidx.compose.ui.input.pointer.isSecondaryPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.isTertiaryPressed
import androidx.compose.ui.input.pointer.positionChanged
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.coroutineScope
import kotlinx.coroutines.launch
import robotran.ui.sheet.DOUBLE_TAP_DISTANCE
import robotran.ui.sheet.DOUBLE_TAP_ZOOM
import robotran.ui.sheet.MAX_WHEEL
import robotran.ui.sheet.SheetTouch
import robotran.ui.sheet.WHEEL_ZOOM
import robotran.ui.sheet.toleranceOf
import robotran.uikit.*
import kotlin.math.abs
import kotlin.math.pow

/**
 * Touch, mouse and wheel in the 3D view. A finger on an element drags it as on the sheet, anywhere else it goes around
 * the paper; two fingers, or the mouse with Shift or another button, move the paper.
 */
internal suspend fun PointerInputScope.spaceGestures(look: SpaceLook, touch: () -> SheetTouch?) = coroutineScope {
    launch { awaitPointerEventScope { while (true) turnWheel(awaitPointerEvent(), look, density) } }
    var lastTap: PointerInputChange? = null
    awaitEachGesture {
        val down = awaitFirstDown()
        val nothing = followFinger(down, look, touch)
        val before = lastTap
        val isSecond = nothing && before != null &&
            down.uptimeMillis - before.uptimeMillis < viewConfiguration.doubleTapTimeoutMillis &&
            (down.position - before.position).getDistance() < DOUBLE_TAP_DISTANCE.toPx()
        if (isSecond) look.zoom(DOUBLE_TAP_ZOOM)
        lastTap = down.takeIf { nothing && !isSecond }
    }
}

private fun turnWheel(event: PointerEvent, look: SpaceLook, density: Float) {
    if (event.type != PointerEventType.Scroll) return
    val change = event.changes.first()
    val turned = event.wheelNotches(density)
    if (change.isConsumed || abs(turned) == 0f) return
    look.zoom(WHEEL_ZOOM.pow(-turned.coerceIn(-MAX_WHEEL, MAX_WHEEL).toDouble()))
    change.consume()
}

/** Handles a gesture from the first finger down to the last one up. Returns whether it was a tap on no element. */
private suspend fun AwaitPointerEventScope.followFinger(
    down: PointerInputChange,
    look: SpaceLook,
    touch: () -> SheetTouch?,
): Boolean {
    val drag = SpaceDrag(look, touch(), down, toleranceOf(down.type))
    val start = currentEvent
    val pans = start.buttons.isSecondaryPressed || start.buttons.isTertiaryPressed ||
        (down.type == PointerType.Mouse && start.keyboardModifiers.isShiftPressed)
    var moved = Offset.Zero
    var looking = false
    try {
        while (true) {
            val event = awaitPointerEvent(PointerEventPass.Main)
            val finger = event.changes.firstOrNull { it.id == down.id }
            if (drag.isOn) {
                if (finger == null || finger.isConsumed || !finger.pressed) break
                drag.move(finger.position)
            } else if (event.changes.none { it.pressed }) {
                if (looking || finger == null || finger.isConsumed) break
                finger.consume()
                return !drag.tap()
            } else if (event.changes.count { it.pressed } > 1) {
                looking = true
                pinch(event, look)
            } else {
                moved += event.calculatePan()
                if (!looking && moved.getDistance() > viewConfiguration.touchSlop) {
                    looking = pans || !drag.take()
                    if (!looking) drag.move(down.position + moved) else look(event, moved, pans, look)
                } else if (looking) {
                    look(event, event.calculatePan(), pans, look)
                }
            }
            if (drag.isOn || looking) event.changes.forEach { if (it.positionChanged()) it.consume() }
        }
    } catch (cancelled: CancellationException) {
        drag.giveUp()
        throw cancelled
    }
    drag.letGo()
    return false
}

private fun look(event: PointerEvent, way: Offset, pans: Boolean, look: SpaceLook) {
    if (way == Offset.Zero) return
    if (!pans) return look.orbit(way)
    val to = event.changes.first().position
    look.push(to - way, to)
}

private fun pinch(event: PointerEvent, look: SpaceLook) {
    val zoom = event.calculateZoom()
    val to = event.calculateCentroid(useCurrent = true)
    if (to == Offset.Unspecified || event.calculateCentroidSize() == 0f) return
    val way = event.calculatePan()
    if (way != Offset.Zero) look.push(to - way, to)
    if (zoom != 1f) look.zoom(zoom.toDouble())
    event.changes.forEach { if (it.positionChanged()) it.consume() }
}

/** A finger that may drag an element: in the horizontal plane through the point at which it has touched it. */
private class SpaceDrag(
    private val look: SpaceLook,
    private val touch: SheetTouch?,
    down: PointerInputChange,
    private val tolerancePixels: Float,
) {
    private val place = look.hit(down.position)

    /** Behind what stands there, for the handle that lies on the paper. */
    private val ground = look.ground(down.position)
    private var height = 0.0

    var isOn = false
        private set

    fun take(): Boolean {
        isOn = tryAt(place) || (place?.isSolid == true && tryAt(ground))
        return isOn
    }

    fun tap(): Boolean = touch != null && place != null && touch.tap(place.point, toleranceAt(place))

    fun move(to: Offset) {
        look.onPlane(to, height)?.let { touch?.drag(it) }
    }

    fun letGo() {
        if (isOn) touch?.letGo()
    }

    fun giveUp() {
        if (isOn) touch?.giveUp()
    }

    private fun tryAt(place: TouchedPlace?): Boolean {
        if (touch == null || place == null || !touch.take(place.point, toleranceAt(place))) return false
        height = place.height
        return true
    }

    /** A finger that has hit something means it. */
    private fun toleranceAt(place: TouchedPlace): Double =
        if (place.scale == 0.0) 0.0 else tolerancePixels / place.scale * if (place.isSolid) SURE else 1.0

    private companion object {
        const val SURE = 0.3
    }
}
