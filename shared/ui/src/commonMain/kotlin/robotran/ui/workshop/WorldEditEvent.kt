package robotran.ui.workshop

/** Something a person does with the world in its editor. */
sealed interface WorldEditEvent : WorkshopEvent {
    /** The world is to be changed. */
    data object EditorOpened : WorldEditEvent

    /** The world is as it should be: robots are put into it. */
    data object EditorClosed : WorldEditEvent
}
