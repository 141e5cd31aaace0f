package robotran.workshop.event

import robotran.workshop.state.Pane

/** A user action about the panes of the screen. */
sealed interface ScreenEvent : WorkshopEvent {
    /** Shows [pane] on screens with room for only one. */
    data class PaneChosen(val pane: Pane) : ScreenEvent

    /** Gives [pane] the room of all others; null shows them side by side again. */
    data class PaneFilled(val pane: Pane?) : ScreenEvent

    /** Shows or hides the task of the world. */
    data class TaskShown(val shown: Boolean) : ScreenEvent

    /** Shows one line of the task of the world, or all of it; an assignment has an event of its own. */
    data class TaskFolded(val folded: Boolean) : ScreenEvent
}
