package robotran.ui.parts

import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.isCtrlPressed

/**
 * Browsers count in pixels; two fingers that move apart on a trackpad are a wheel with Ctrl to them, in much smaller
 * steps.
 */
internal actual fun PointerEvent.wheelNotches(density: Float): Float {
    val pixels = changes.fold(0f) { sum, change -> sum + change.scrollDelta.y } / density
    return if (keyboardModifiers.isCtrlPressed) (pixels / PINCH_STEP).coerceIn(-1f, 1f) else pixels / NOTCH
}

/** What browsers make of a notch. */
private const val NOTCH = 100f

/** So many make the things on the sheet follow the fingers: they grow by a hundredth for each pixel. */
private const val PINCH_STEP = 14f
