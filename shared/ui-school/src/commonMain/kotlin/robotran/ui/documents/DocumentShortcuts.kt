package robotran.ui.documents

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.workshop.event.DocumentEvent

/** The event for a document shortcut with Ctrl or, on a Mac, Command; null for none. Browsers reserve Ctrl N. */
fun documentShortcut(event: KeyEvent): DocumentEvent? {
    val held = (event.isCtrlPressed || event.isMetaPressed) && !event.isAltPressed
    if (event.type != KeyEventType.KeyDown || !held) return null
    return when (event.key) {
        Key.S -> if (event.isShiftPressed) DocumentEvent.SaveAsRequested else DocumentEvent.SaveRequested
        Key.O -> if (event.isShiftPressed) DocumentEvent.ProjectListRequested else DocumentEvent.OpenRequested
        else -> null
    }
}
