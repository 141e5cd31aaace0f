package robotran.workshop.event

import robotran.worldediting.Edit

/** Something a person does with the world in its editor. */
sealed interface WorldEditEvent : WorkshopEvent {
    /** The world is to be changed. */
    data object EditorOpened : WorldEditEvent

    /** Something is to be done to the world. */
    data class Edited(val edit: Edit) : WorldEditEvent

    /**
     * The world is as it should be: robots are put into it. If something has to be mended first, that is pointed out.
     */
    data object EditorClosed : WorldEditEvent

    /** The same, and the program runs in it at once. */
    data object TriedOut : WorldEditEvent

    /** What has to be mended is not to be told any longer, until that is something else or it is asked for again. */
    data object HintsClosed : WorldEditEvent

    /** The world is to be as it was before it was changed. */
    data object EditsDiscarded : WorldEditEvent
}
