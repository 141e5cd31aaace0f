package robotran.android

import androidx.core.os.bundleOf
import androidx.lifecycle.SavedStateHandle
import robotran.ui.workshop.Pane
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.SettingsEvent
import robotran.ui.workshop.Workshop
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorldEditEvent
import robotran.ui.workshop.DrawerTab

/** What of [workshop] is on the screen, beside the work itself: Android keeps it when it ends the process. */
internal class ShownScreen(private val workshop: Workshop) {
    /** Shows what was shown when [saved] was written, if it ever was, and writes it from now on. */
    fun restoreFrom(saved: SavedStateHandle) {
        saved.get<android.os.Bundle>(KEY)?.let { shown ->
            Pane.entries.find { it.name == shown.getString(PANE) }?.let { workshop.handle(WorkshopEvent.PaneChosen(it)) }
            DrawerTab.entries.find { it.name == shown.getString(DRAWER) }?.let { workshop.handle(RunEvent.DrawerChosen(it)) }
            if (shown.getBoolean(SETTINGS)) workshop.handle(SettingsEvent.SettingsShown(true))
            if (shown.getBoolean(EDITOR)) workshop.handle(WorldEditEvent.EditorOpened)
        }
        saved.setSavedStateProvider(KEY) {
            val state = workshop.state
            bundleOf(
                PANE to state.pane.name,
                DRAWER to state.run.drawer.tab?.name,
                SETTINGS to state.settingsShown,
                EDITOR to (state.worldEdit != null),
            )
        }
    }

    private companion object {
        const val KEY = "screen"
        const val PANE = "pane"
        const val DRAWER = "drawer"
        const val SETTINGS = "settings"
        const val EDITOR = "editor"
    }
}
