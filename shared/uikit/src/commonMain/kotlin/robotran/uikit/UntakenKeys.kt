package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.input.key.KeyEvent

/** Keys of a window that nothing on its screen has taken: while nothing there has the focus, Compose gives them to nobody. */
class UntakenKeys {
    internal var taker: ((KeyEvent) -> Boolean)? = null

    /** Returns whether somebody has taken [event]. */
    fun take(event: KeyEvent): Boolean = taker?.invoke(event) == true
}

/** What the window gives such keys to; null if it gives them to nobody. */
val LocalUntakenKeys = staticCompositionLocalOf<UntakenKeys?> { null }

/** Gives the window's untaken keys to [onKey] as long as this is on the screen. */
@Composable
fun TakesUntakenKeys(onKey: (KeyEvent) -> Boolean) {
    val keys = LocalUntakenKeys.current ?: return
    val latest by rememberUpdatedState(onKey)
    DisposableEffect(keys) {
        val taker: (KeyEvent) -> Boolean = { latest(it) }
        keys.taker = taker
        onDispose { if (keys.taker === taker) keys.taker = null }
    }
}
