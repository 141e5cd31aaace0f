package robotran.android

import android.view.KeyEvent
import robotran.ui.documents.documentShortcut
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage
import androidx.compose.ui.input.key.KeyEvent as ComposeKeyEvent

/** The event for a key of a hardware keyboard, with the same shortcuts as the desktop menus; null for none. */
internal fun eventForKey(event: KeyEvent): WorkshopEvent? {
    val help = LearningEvent.PageRequested(LearningPage.HELP)
    return when {
        event.keyCode == KeyEvent.KEYCODE_F5 -> if (event.isShiftPressed) RunEvent.StopPressed else RunEvent.RunPressed
        event.keyCode == KeyEvent.KEYCODE_F1 -> if (event.isShiftPressed) LearningEvent.TutorialStarted else help
        event.isCtrlPressed && event.keyCode == KeyEvent.KEYCODE_COMMA -> SettingsEvent.SettingsShown(true)
        event.isCtrlPressed && event.keyCode == KeyEvent.KEYCODE_N -> DocumentEvent.NewRequested
        else -> documentShortcut(ComposeKeyEvent(event))
    }
}
