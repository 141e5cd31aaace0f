package robotran.ui.screen

import robotran.ui.worldedit.escaped
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopState

/**
 * What Back closes of the pages that lie over the workshop, the topmost first; menus and dialogs close by themselves.
 */
internal fun pageBackEvents(state: WorkshopState): List<WorkshopEvent> = buildList {
    if (state.settingsShown) add(SettingsEvent.SettingsShown(false))
    if (state.learning.page != null) add(LearningEvent.PageLeft)
    state.worldEdit?.let { edit ->
        escaped(edit.editing)?.let { add(WorldEditEvent.Edited(it)) }
        add(WorldEditEvent.EditorClosed)
    }
}

/**
 * What Back closes of the workshop itself; where there is room for one pane only, it goes to the world from the others.
 * Nothing where Back leaves the app.
 */
internal fun paneBackEvents(state: WorkshopState, isWide: Boolean): List<WorkshopEvent> = buildList {
    if (!isWide) {
        if (state.learning.tutorial?.isFolded == false) add(LearningEvent.TutorialFolded(true))
        if (state.pane != Pane.WORLD) add(WorkshopEvent.PaneChosen(Pane.WORLD))
    }
    if (state.run.drawer.tab != null) add(RunEvent.DrawerChosen(null))
}
