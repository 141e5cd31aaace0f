package robotran.workshop.event

import robotran.workshop.state.Pane

/** A user action in the workshop; each pane has its own subtype. */
sealed interface WorkshopEvent {
    /** Shows [pane] on screens with room for only one. */
    data class PaneChosen(val pane: Pane) : WorkshopEvent

    /** Gives [pane] the room of all others; null shows them side by side again. */
    data class PaneFilled(val pane: Pane?) : WorkshopEvent

    /** Shows or hides the task of the world. */
    data class TaskShown(val shown: Boolean) : WorkshopEvent

    /** Shows one line of the task of the world, or all of it; an assignment has an event of its own. */
    data class TaskFolded(val folded: Boolean) : WorkshopEvent

    /** Dismisses the notice at the bottom. */
    data object NoticeDismissed : WorkshopEvent

    /** Performs the action that the notice offers. */
    data object NoticeTaken : WorkshopEvent
}
