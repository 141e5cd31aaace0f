package robotran.uikit

import androidx.compose.runtime.Composable
import androidx.compose.ui.ExperimentalComposeUiApi
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.InputMode
import androidx.compose.ui.input.InputModeManager
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.pointer.PointerEventPass
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalInputModeManager

/**
 * Whether the last input was a key. Then a ring shows the focus, and a sheet that opens takes it; after a touch it does
 * not, since a field with the focus would bring up the keyboard of a tablet.
 */
val InputModeManager.areKeysInUse: Boolean get() = inputMode == InputMode.Keyboard

/**
 * Tells Compose about touches and keys within. On its own it takes a mouse for a touch, but not a finger, and only keys
 * that move the focus for keys. In [InputMode.Touch] a button neither gets nor keeps the focus.
 */
@OptIn(ExperimentalComposeUiApi::class)
@Composable
internal fun Modifier.tellsInputMode(): Modifier {
    val manager = LocalInputModeManager.current
    return onPreviewKeyEvent { event ->
        if (event.type == KeyEventType.KeyDown && event.key !in NOT_OF_A_KEYBOARD) manager.enter(InputMode.Keyboard)
        false
    }.pointerInput(manager) {
        awaitPointerEventScope {
            while (true) {
                // Before anything within can take the focus.
                val event = awaitPointerEvent(PointerEventPass.Initial)
                if (event.changes.any { it.pressed }) manager.enter(InputMode.Touch)
            }
        }
    }
}

@OptIn(ExperimentalComposeUiApi::class)
private fun InputModeManager.enter(mode: InputMode) {
    if (inputMode != mode) requestInputMode(mode)
}

/** Held for a shortcut or a click, or at the rim of a phone. */
private val NOT_OF_A_KEYBOARD = setOf(
    Key.ShiftLeft,
    Key.ShiftRight,
    Key.CtrlLeft,
    Key.CtrlRight,
    Key.AltLeft,
    Key.AltRight,
    Key.MetaLeft,
    Key.MetaRight,
    Key.Back,
    Key.VolumeUp,
    Key.VolumeDown,
    Key.VolumeMute,
)
