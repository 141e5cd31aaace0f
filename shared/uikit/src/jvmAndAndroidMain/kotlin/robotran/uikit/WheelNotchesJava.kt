package robotran.uikit

import androidx.compose.ui.input.pointer.PointerEvent

/** Java and Android count in notches. */
actual fun PointerEvent.wheelNotches(density: Float): Float = changes.fold(0f) { sum, change ->
    sum +
        change.scrollDelta.y
}
