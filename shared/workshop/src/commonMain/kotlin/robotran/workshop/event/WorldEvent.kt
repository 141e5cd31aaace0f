package robotran.workshop.event

/** A user action on the sheet or in an editor of the world and its robots. */
sealed interface WorldEvent : WorkshopEvent
