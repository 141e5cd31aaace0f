package robotran.ui.screen

import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.Pane
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorldEditEvent
import robotran.ui.worldedit.escaped

/** What Back closes of the pages that lie over the workshop, the topmost first; menus and dialogs close by themselves. */
internal fun pageBackEvents(state: WorkshopState): List<WorkshopEvent> = buildList {
    if (state.settingsShown) add(SettingsEvent.SettingsShown(false))
    if (state.learning.page != null) add(LearningEvent.PageLeft)
    state.worldEdit?.let { edit ->
        escaped(edit.editing)?.let { add(WorldEditEvent.Edited(it)) }
        add(WorldEditEvent.EditorClosed)
    }
}

/** What Back closes of the workshop itself; where there is room for one pane only, it goes to the world from the others. Nothing where Back leaves the app. */
internal fun paneBackEvents(state: WorkshopState, isWide: Boolean): List<WorkshopEvent> = buildList {
    if (!isWide) {
        if (state.learning.tutorial?.isFolded == false) add(LearningEvent.TutorialFolded(true))
        if (state.pane != Pane.WORLD) add(WorkshopEvent.PaneChosen(Pane.WORLD))
    }
    if (state.run.drawer.tab != null) add(RunEvent.DrawerChosen(null))
}
