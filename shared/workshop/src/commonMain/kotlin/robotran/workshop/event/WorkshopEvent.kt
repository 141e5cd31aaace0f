package robotran.workshop.event

import robotran.workshop.state.Pane

/** What a person does in the workshop; each pane has a kind of its own. */
sealed interface WorkshopEvent {
    /** Where there is room for one pane only, it is to be [pane]. */
    data class PaneChosen(val pane: Pane) : WorkshopEvent

    /** What is to be done in the world is to be seen or not. */
    data class TaskShown(val shown: Boolean) : WorkshopEvent

    /** The notice at the lower edge was read. */
    data object NoticeDismissed : WorkshopEvent

    /** What the notice offers is wanted. */
    data object NoticeTaken : WorkshopEvent
}
