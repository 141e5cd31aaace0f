package robotran.ui.workshop

/** Something a person does with how the world is shown. */
sealed interface SheetEvent : WorkshopEvent {
    /** The whole sheet is wanted again. */
    data object WholeSheetWanted : SheetEvent
}
