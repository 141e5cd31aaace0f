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
import robotran.rcxrom.program.StepKind
import robotran.workshop.event.RunEvent

/**
 * What a key does with the run, wherever the focus is; null for nothing. Ctrl (on a Mac also Command) with Enter runs,
 * with Shift it stops; F6 pauses, F7 steps: alone into what a line calls, with Ctrl over it, with Shift out of it. F10
 * and F11, which other debuggers take, belong to menus and browsers.
 */
internal fun runShortcut(event: KeyEvent): RunEvent? {
    if (event.type != KeyEventType.KeyDown || event.isAltPressed) return null
    val shift = event.isShiftPressed
    val control = event.isCtrlPressed || event.isMetaPressed
    return when (event.key) {
        Key.Enter -> (if (shift) RunEvent.StopPressed else RunEvent.RunPressed).takeIf { control }
        Key.F6 -> RunEvent.PausePressed.takeIf { !shift && !control }
        Key.F7 -> stepFor(control, shift)?.let(RunEvent::StepPressed)
        else -> null
    }
}

private fun stepFor(control: Boolean, shift: Boolean): StepKind? = when {
    control && shift -> null
    control -> StepKind.OVER
    shift -> StepKind.OUT
    else -> StepKind.INTO
}
