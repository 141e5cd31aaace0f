package robotran.workshop.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.RunControls
import robotran.workshop.state.WorldEditState
import robotran.worldediting.Edit
import robotran.worldediting.WorldEditing
import robotran.worldediting.after

/**
 * Holds the edited world; null while it is not edited. Valid states are saved at once, so that a crash loses nothing.
 */
class WorldEditStateHolder(
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val runControls: RunControls,
) {
    private var latest: WorldEditing? = null

    var state: WorldEditState? by mutableStateOf(null)
        private set

    fun handle(event: WorldEditEvent) {
        when (event) {
            WorldEditEvent.EditorOpened -> open()
            is WorldEditEvent.Edited -> edit(event.edit)
            WorldEditEvent.EditorClosed -> close()
            WorldEditEvent.TriedOut -> if (close()) runControls.run()
            WorldEditEvent.HintsClosed -> state = state?.copy(hintsShown = false)
            WorldEditEvent.EditsDiscarded -> discard()
        }
    }

    /** If the world has not changed since the editor was closed, restores its groups and undo history. */
    private fun open() {
        if (state != null) return
        val world = current.project.world
        val editing = latest?.takeIf { it.world == world } ?: WorldEditing.of(world)
        state = WorldEditState(editing.after(Edit.Select(null)).after(Edit.FinishChange), world)
    }

    private fun edit(edit: Edit) {
        val now = state ?: return
        val editing = now.editing.after(edit)
        val hasNews = editing.error != null || editing.errors != now.editing.errors
        state = now.copy(
            editing = editing,
            hasFailedToClose = now.hasFailedToClose && editing.errors.isNotEmpty(),
            hintsShown = now.hintsShown || hasNews,
        )
        val canBeKept = editing.gesture == null && editing.errors.isEmpty()
        if (canBeKept && editing.world != current.project.world) editor.saveWorld(editing.world)
    }

    /** Closes the editor. Returns whether it is closed. */
    private fun close(): Boolean {
        val now = state ?: return false
        val editing = now.editing.after(Edit.Drop)
        val error = editing.errors.firstOrNull()
        if (error != null) {
            val shown = error.thing?.let { editing.after(Edit.Select(it)) } ?: editing
            state = now.copy(editing = shown, hasFailedToClose = true, hintsShown = true)
            return false
        }
        latest = editing
        state = null
        if (now.isChanged) editor.changeWorld(editing.world)
        return true
    }

    /** Called when another world is loaded; valid states of the edited world are already saved. */
    fun leave() {
        latest = null
        state = null
    }

    private fun discard() {
        val now = state ?: return
        state = null
        if (current.project.world != now.first) editor.saveWorld(now.first)
    }
}
