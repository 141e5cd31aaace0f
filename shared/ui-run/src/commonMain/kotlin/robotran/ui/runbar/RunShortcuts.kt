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
import robotran.brick.program.StepKind
import robotran.workshop.event.RunEvent

/**
 * The event for a run shortcut with any focus; null for none. Ctrl (on a Mac also Command) with Enter runs, with Shift
 * it stops. F6 pauses, with Shift it makes the run heard. F7 steps into calls, with Ctrl over them, with Shift out. F10 and F11, common in other
 * debuggers, are used by menus and browsers.
 */
fun runShortcut(event: KeyEvent): RunEvent? {
    if (event.type != KeyEventType.KeyDown || event.isAltPressed) return null
    val shift = event.isShiftPressed
    val control = event.isCtrlPressed || event.isMetaPressed
    return when (event.key) {
        Key.Enter -> (if (shift) RunEvent.StopPressed else RunEvent.RunPressed).takeIf { control }
        Key.F6 -> (if (shift) RunEvent.HearingSwitched else RunEvent.PausePressed).takeIf { !control }
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
