package robotran.ui.runbar

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isAltPressed
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.rom.StepKind
import robotran.ui.workshop.RunEvent

/**
 * What a key does with the run, wherever the focus is; null for nothing. Ctrl (on a Mac also Command) with Enter runs, with Shift it stops; F6 pauses, F10 and F11
 * step as in other debuggers. Browsers keep F11 to themselves.
 */
internal fun runShortcut(event: KeyEvent): RunEvent? {
    if (event.type != KeyEventType.KeyDown || event.isAltPressed) return null
    val shift = event.isShiftPressed
    if (event.isCtrlPressed || event.isMetaPressed) {
        return if (event.key == Key.Enter) (if (shift) RunEvent.StopPressed else RunEvent.RunPressed) else null
    }
    return when (event.key) {
        Key.F6 -> RunEvent.PausePressed.takeIf { !shift }
        Key.F10 -> RunEvent.StepPressed(StepKind.OVER).takeIf { !shift }
        Key.F11 -> RunEvent.StepPressed(if (shift) StepKind.OUT else StepKind.INTO)
        else -> null
    }
}
