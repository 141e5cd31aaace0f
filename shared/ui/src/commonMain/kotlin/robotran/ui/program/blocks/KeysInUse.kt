package robotran.ui.program.blocks

import androidx.compose.runtime.compositionLocalOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.pointerInput

/**
 * Whether the last input was a key. Then a sheet that opens takes the focus; after a touch it does not, since a field
 * with the focus would bring up the keyboard of a tablet.
 */
internal class KeysInUse {
    var isNow by mutableStateOf(false)
}

internal val LocalKeysInUse = compositionLocalOf { KeysInUse() }

/** Notes what kind of input comes here. */
internal fun Modifier.noting(keys: KeysInUse): Modifier = onPreviewKeyEvent {
    keys.isNow = true
    false
}.pointerInput(keys) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent(PointerEventPass.Initial)
            if (event.changes.any { it.pressed }) keys.isNow = false
        }
    }
}
