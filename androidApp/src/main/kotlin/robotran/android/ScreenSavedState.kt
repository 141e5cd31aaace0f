package robotran.android

import android.os.Bundle
import androidx.core.os.bundleOf
import androidx.lifecycle.SavedStateHandle
import robotran.workshop.Workshop
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.Pane

/** Saves the UI state outside of the project in [saved] when Android ends the process. */
internal class ScreenSavedState(private val saved: SavedStateHandle, private val run: RunPersistence) {
    /** Restores the saved UI state of [workshop] if the process was ended, and saves later changes. */
    suspend fun restore(workshop: Workshop) {
        saved.get<Bundle>(KEY)?.let { shown ->
            run.restore(workshop, shown.getLong(TIME))
            DrawerTab.entries.find {
                it.name == shown.getString(DRAWER)
            }?.let { workshop.handle(RunEvent.DrawerChosen(it)) }
            Pane.entries.find {
                it.name == shown.getString(PANE)
            }?.let { workshop.handle(ScreenEvent.PaneChosen(it)) }
            if (shown.getBoolean(SETTINGS)) workshop.handle(SettingsEvent.SettingsShown(true))
            if (shown.getBoolean(EDITOR)) workshop.handle(WorldEditEvent.EditorOpened)
        }
        saved.setSavedStateProvider(KEY) { describe(workshop) }
    }

    private fun describe(workshop: Workshop): Bundle {
        val state = workshop.state
        return bundleOf(
            TIME to state.run.time,
            DRAWER to state.run.drawer.tab?.name,
            PANE to state.pane.name,
            SETTINGS to state.settingsShown,
            EDITOR to (state.worldEdit != null),
        )
    }

    private companion object {
        const val KEY = "screen"
        const val TIME = "time"
        const val DRAWER = "drawer"
        const val PANE = "pane"
        const val SETTINGS = "settings"
        const val EDITOR = "editor"
    }
}
