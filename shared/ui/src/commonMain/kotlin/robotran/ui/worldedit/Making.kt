package robotran.ui.worldedit

import androidx.compose.runtime.Immutable
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.worldediting.Edit
import robotran.worldediting.Piece
import robotran.worldediting.Thing
import robotran.worldediting.WorldEditing

/** What the parts of the editor see, and how they say what is to be done. */
@Immutable
internal class Making(val editing: WorldEditing, private val onEvent: (WorkshopEvent) -> Unit) {
    val world get() = editing.world

    /** One step. */
    fun make(edit: Edit) = onEvent(WorldEditEvent.Edited(edit))

    /** A part of a longer change, such as a character of a name; [settle] ends it. */
    fun change(thing: Thing, piece: Piece) = make(Edit.Change(thing, piece))

    /** A change that is a step of its own. */
    fun changeAtOnce(thing: Thing, piece: Piece) {
        settle()
        change(thing, piece)
        settle()
    }

    fun settle() = make(Edit.Settle)

    fun perform(event: WorldEditEvent) = onEvent(event)
}
