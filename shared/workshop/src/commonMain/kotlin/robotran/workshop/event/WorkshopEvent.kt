package robotran.workshop.event

/** A user action in the workshop; each room has its own subtypes. */
sealed interface WorkshopEvent {
    /** Dismisses the notice at the bottom. */
    data object NoticeDismissed : WorkshopEvent

    /** Performs the action that the notice offers. */
    data object NoticeTaken : WorkshopEvent
}
