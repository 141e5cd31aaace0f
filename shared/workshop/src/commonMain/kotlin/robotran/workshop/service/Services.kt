package robotran.workshop.service

import kotlinx.coroutines.CoroutineScope
import robotran.language.Language
import robotran.workshop.platform.Platform

/**
 * What the rooms of the workshop share. Each room gets this record and takes from it what it needs.
 *
 * @property scope lives as long as the workshop; runs on the UI thread.
 * @param tabs made after the record, by a room that takes other things from it.
 * @param runControls likewise.
 */
class Services(
    val platform: Platform,
    val scope: CoroutineScope,
    val preferences: Preferences,
    val current: CurrentProject,
    val editor: ProjectEditor,
    val assignments: AssignmentRepository,
    val navigator: ScreenNavigator,
    val notices: Notices,
    val events: RoomEvents,
    tabs: () -> ProgramTabs,
    runControls: () -> RunControls,
) {
    val tabs: ProgramTabs by lazy(LazyThreadSafetyMode.NONE, tabs)
    val runControls: RunControls by lazy(LazyThreadSafetyMode.NONE, runControls)

    val language: Language get() = preferences.language

    fun publish(event: RoomEvent) = events.publish(event)
}
