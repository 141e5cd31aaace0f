package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import androidx.compose.ui.input.key.utf16CodePoint

/** `+` and `-` zoom, `0` shows the whole sheet, the arrows pan it. Returns whether the key was handled. */
internal fun SheetLook.onKey(event: KeyEvent): Boolean {
    if (event.type != KeyEventType.KeyDown || event.isAltPressed || event.isCtrlPressed || event.isMetaPressed) {
        return false
    }
    val push = PUSHES[event.key]
    when {
        push != null -> push(push)
        event.isSign('+', setOf(Key.Plus, Key.NumPadAdd)) || event.key == Key.Equals -> zoom(KEY_ZOOM)
        event.isSign('-', setOf(Key.Minus, Key.NumPadSubtract)) -> zoom(1 / KEY_ZOOM)
        event.isSign('0', setOf(Key.Zero, Key.NumPad0)) -> zoom(0.0)
        else -> return false
    }
    return true
}

/** The key of a character depends on the keyboard, and some platforms report only the key. */
fun KeyEvent.isSign(sign: Char, keys: Set<Key>): Boolean = utf16CodePoint == sign.code || key in keys

const val KEY_ZOOM = 1.3
private const val STEP_PIXELS = 60f

/** To look to the right, the sheet moves to the left. */
private val PUSHES = mapOf(
    Key.DirectionLeft to Offset(STEP_PIXELS, 0f),
    Key.DirectionRight to Offset(-STEP_PIXELS, 0f),
    Key.DirectionUp to Offset(0f, STEP_PIXELS),
    Key.DirectionDown to Offset(0f, -STEP_PIXELS),
)
