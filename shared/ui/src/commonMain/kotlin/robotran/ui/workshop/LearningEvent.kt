package robotran.ui.workshop

/** Something a person does with what there is to learn from. */
sealed interface LearningEvent : WorkshopEvent {
    /** What [page] has to tell is wanted. */
    data class PageWanted(val page: LearningPage) : LearningEvent

    /** Back to the workshop. */
    data object PageLeft : LearningEvent

    /** Help on the word at [offset] of [text] is wanted. */
    data class HelpWanted(val text: String, val offset: Int) : LearningEvent
}

/** What there is to learn from. */
enum class LearningPage { FIRST_RUN, TUTORIAL, WORLDS, HELP }
