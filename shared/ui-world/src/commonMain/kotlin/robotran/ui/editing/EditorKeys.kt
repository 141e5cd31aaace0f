package robotran.ui.editing

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.editing.CommonEdits

/**
 * The edit for Ctrl and a key, if the focused element has not consumed it.
 *
 * @param other the edit for keys that not every editor has.
 */
internal fun <T : Any> editForCommand(event: KeyEvent, edits: CommonEdits<T>, other: (Key) -> T? = { null }): T? {
    if (event.type != KeyEventType.KeyDown || !(event.isCtrlPressed || event.isMetaPressed)) return null
    return when (event.key) {
        Key.Z -> if (event.isShiftPressed) edits.redo else edits.undo
        Key.Y -> edits.redo
        else -> other(event.key)
    }
}

/** How far an arrow moves with Shift, in centimetres. */
internal const val FINE_STEP = 0.1
