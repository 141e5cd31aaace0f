package robotran.ui.screen

import androidx.compose.runtime.Composable
import androidx.compose.runtime.State
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.runtime.setValue
import androidx.compose.ui.unit.Dp
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.Settings
import robotran.workshop.state.WindowForm

/**
 * The share of the program in a window: as it is dragged, else as it was chosen in such a window, else as Robotran
 * chooses. Only the end of a drag is stored.
 */
internal class ChosenShare(private val form: WindowForm, private val onEvent: State<(WorkshopEvent) -> Unit>) {
    private var dragged: Float? by mutableStateOf(null)

    /** The share, or null for as much as Robotran chooses. */
    fun of(settings: Settings): Float? = dragged ?: settings.panes[form].programShare

    /** Gives the program [share]; null for as much as Robotran chooses. Stores it if it [stays]. */
    fun put(share: Float?, stays: Boolean) {
        dragged = share.takeUnless { stays }
        if (stays) onEvent.value(SettingsEvent.ProgramShareChosen(form, share))
    }
}

@Composable
internal fun rememberChosenShare(form: WindowForm, onEvent: (WorkshopEvent) -> Unit): ChosenShare {
    val tell = rememberUpdatedState(onEvent)
    return remember(form) { ChosenShare(form, tell) }
}

/** The shares of [whole] that leave the program [program] and the world [world]; a half if there is not enough. */
internal fun sharesOf(whole: Dp, program: Dp, world: Dp): ClosedFloatingPointRange<Float> {
    if (program + world >= whole) return HALF..HALF
    return program / whole..1 - world / whole
}

private const val HALF = 0.5f
