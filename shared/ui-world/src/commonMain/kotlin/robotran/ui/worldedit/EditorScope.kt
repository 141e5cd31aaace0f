package robotran.ui.worldedit

import androidx.compose.runtime.Immutable
import robotran.ui.editing.EditScope
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing

/** What the parts of the editor read, and how they send edits. */
@Immutable
internal class EditorScope(val editing: WorldEditing, onEvent: (WorkshopEvent) -> Unit) :
    EditScope<WorldEdit>(WorldEdit.COMMON, WorldEditEvent::Edited, onEvent) {
    val world get() = editing.world
}
