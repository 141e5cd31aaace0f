package robotran.ui.workshop

/** Something a person does with the project as a whole. */
sealed interface DocumentEvent : WorkshopEvent {
    /** The project is to be called [name]. */
    data class Renamed(val name: String) : DocumentEvent
}
