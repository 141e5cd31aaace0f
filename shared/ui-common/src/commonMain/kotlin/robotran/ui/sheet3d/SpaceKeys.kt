package robotran.ui.sheet3d

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.ui.sheet.KEY_ZOOM
import robotran.ui.sheet.isSign

/** The arrows go around the paper, `+` and `-` zoom, `0` returns to the view of the beginning. */
internal fun SpaceLook.onKey(event: KeyEvent): Boolean {
    if (event.type != KeyEventType.KeyDown || event.isAltPressed || event.isCtrlPressed || event.isMetaPressed) {
        return false
    }
    val turn = TURNS[event.key]
    when {
        turn != null -> turn(turn.first, turn.second)
        event.isSign('+', setOf(Key.Plus, Key.NumPadAdd)) || event.key == Key.Equals -> zoom(KEY_ZOOM)
        event.isSign('-', setOf(Key.Minus, Key.NumPadSubtract)) -> zoom(1 / KEY_ZOOM)
        event.isSign('0', setOf(Key.Zero, Key.NumPad0)) -> reset()
        else -> return false
    }
    return true
}

/** In degrees: around the paper, and up or down. */
private val TURNS = mapOf(
    Key.DirectionLeft to (-15.0 to 0.0),
    Key.DirectionRight to (15.0 to 0.0),
    Key.DirectionUp to (0.0 to 6.0),
    Key.DirectionDown to (0.0 to -6.0),
)
