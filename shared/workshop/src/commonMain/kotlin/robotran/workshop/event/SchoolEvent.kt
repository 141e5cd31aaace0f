package robotran.workshop.event

/** A user action about learning, assignments, hand-ins or what becomes of a program. */
sealed interface SchoolEvent : WorkshopEvent
