package robotran.uikit

import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.isCtrlPressed

/** Browsers report pixels. A pinch on a trackpad is reported as a wheel with Ctrl, in much smaller steps. */
actual fun PointerEvent.wheelNotches(density: Float): Float {
    val pixels = changes.fold(0f) { sum, change -> sum + change.scrollDelta.y } / density
    return if (keyboardModifiers.isCtrlPressed) (pixels / PINCH_STEP).coerceIn(-1f, 1f) else pixels / NOTCH
}

/** The pixels per notch in browsers. */
private const val NOTCH = 100f

/** With this factor elements on the sheet follow the fingers: they grow by a hundredth per pixel. */
private const val PINCH_STEP = 14f
