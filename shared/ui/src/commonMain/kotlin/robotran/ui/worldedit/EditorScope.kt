package robotran.ui.worldedit

import androidx.compose.runtime.Immutable
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.worldediting.Element
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing

/** What the parts of the editor read, and how they send edits. */
@Immutable
internal class EditorScope(val editing: WorldEditing, private val onEvent: (WorkshopEvent) -> Unit) {
    val world get() = editing.world

    /** Sends one edit. */
    fun make(edit: WorldEdit) = onEvent(WorldEditEvent.Edited(edit))

    /** Sends a part of a longer change, such as a character of a name; [settle] ends it. */
    fun change(ref: ElementRef, element: Element) = make(WorldEdit.Change(ref, element))

    /** Sends a change as a step of its own. */
    fun changeAtOnce(ref: ElementRef, element: Element) {
        settle()
        change(ref, element)
        settle()
    }

    fun settle() = make(WorldEdit.FinishChange)

    fun perform(event: WorldEditEvent) = onEvent(event)

    /** Opens the workbench with the robot of this index. */
    fun build(robot: Int) = onEvent(RobotEditEvent.BenchOpened(robot))
}
