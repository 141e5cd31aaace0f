package robotran.uikit

import androidx.compose.foundation.focusable
import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.pointerInput

/**
 * Reports press and release separately, for touch, mouse, and the space and enter keys while focused. Every press is
 * released, also when the focus is lost or the button disappears.
 */
@Composable
fun Modifier.holdable(onPress: () -> Unit, onRelease: () -> Unit): Modifier {
    val press = rememberUpdatedState(onPress)
    val release = rememberUpdatedState(onRelease)
    val hold = remember { PressTracker({ press.value() }, { release.value() }) }
    DisposableEffect(hold) { onDispose { hold.letGo() } }
    return pointerInput(hold) {
        awaitEachGesture {
            awaitFirstDown(requireUnconsumed = false).consume()
            hold.down(PressTracker.Source.POINTER)
            try {
                do {
                    val event = awaitPointerEvent()
                    event.changes.forEach { it.consume() }
                } while (event.changes.any { it.pressed })
            } finally {
                hold.up(PressTracker.Source.POINTER)
            }
        }
    }
        .onFocusChanged { if (!it.isFocused) hold.up(PressTracker.Source.KEY) }
        .onKeyEvent { hold.onKey(it) }
        .focusable()
}

/** Tracks the sources that hold a button; it is released with the last one. */
private class PressTracker(private val onPress: () -> Unit, private val onRelease: () -> Unit) {
    enum class Source { POINTER, KEY }

    private val sources = mutableSetOf<Source>()

    fun down(source: Source) {
        val wasFree = sources.isEmpty()
        if (sources.add(source) && wasFree) onPress()
    }

    fun up(source: Source) {
        if (sources.remove(source) && sources.isEmpty()) onRelease()
    }

    fun letGo() = Source.entries.forEach(::up)

    fun onKey(event: KeyEvent): Boolean {
        if (event.key != Key.Spacebar && event.key != Key.Enter && event.key != Key.NumPadEnter) return false
        if (event.type == KeyEventType.KeyDown) down(Source.KEY) else up(Source.KEY)
        return true
    }
}
