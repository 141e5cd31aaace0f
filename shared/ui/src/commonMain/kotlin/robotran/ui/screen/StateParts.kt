package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.remember
import robotran.ui.drawer.RunAnnouncer
import robotran.workshop.state.WorkshopState

/**
 * What [read] finds in the state, which must depend on nothing else. The caller is drawn again when that changes, not
 * with each frame of a run.
 */
@Composable
internal fun <T> WorkshopState.part(read: WorkshopState.() -> T): T = remember(this) { derivedStateOf { read() } }.value

/** [RunAnnouncer] in a scope of its own, which each frame of a run composes. */
@Composable
internal fun RunAnnouncements(state: WorkshopState) {
    // A run that is told in words needs no other ones.
    if (!state.settings.tellsRuns) RunAnnouncer(state.run)
}
