package robotran.ui.screen

import robotran.ui.workshop.DocumentEvent
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.Pane
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorldEditEvent
import robotran.ui.worldedit.escaped

/**
 * What Back does while [state] is shown: it closes what lies over the rest, the topmost first, and where there is room for one pane only it
 * goes to the world from the others. Null where Back leaves the app.
 */
internal fun backEvent(state: WorkshopState, isWide: Boolean): WorkshopEvent? {
    val edit = state.worldEdit
    return when {
        state.document.dialog != null -> DocumentEvent.DialogClosed
        state.settingsShown -> SettingsEvent.SettingsShown(false)
        state.learning.page != null -> LearningEvent.PageLeft
        edit != null -> escaped(edit.editing)?.let(WorldEditEvent::Edited) ?: WorldEditEvent.EditorClosed
        isWide -> RunEvent.DrawerChosen(null).takeIf { state.run.drawer.tab != null }
        state.learning.tutorial?.isFolded == false -> LearningEvent.TutorialFolded(true)
        state.pane != Pane.WORLD -> WorkshopEvent.PaneChosen(Pane.WORLD)
        state.run.drawer.tab != null -> RunEvent.DrawerChosen(null)
        else -> null
    }
}
