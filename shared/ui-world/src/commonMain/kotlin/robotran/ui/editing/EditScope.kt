package robotran.ui.editing

import androidx.compose.runtime.Immutable
import robotran.editing.CommonEdits
import robotran.workshop.event.WorkshopEvent

/**
 * How the parts of an editor send edits.
 *
 * @param eventOf the event of an edit.
 */
@Immutable
internal abstract class EditScope<T : Any>(
    val edits: CommonEdits<T>,
    private val eventOf: (T) -> WorkshopEvent,
    private val onEvent: (WorkshopEvent) -> Unit,
) {
    /** Sends one edit, or a part of a longer change; [settle] ends it. */
    fun make(edit: T) = onEvent(eventOf(edit))

    /** Sends an edit as a step of its own. */
    fun makeAtOnce(edit: T) {
        settle()
        make(edit)
        settle()
    }

    fun settle() = make(edits.finish)

    fun perform(event: WorkshopEvent) = onEvent(event)
}
