package robotran.workshop.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.simulation.state.MissingSensor
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.RunControls
import robotran.workshop.state.Notice
import robotran.workshop.state.WorldEditState
import robotran.world.World
import robotran.worldediting.Edit
import robotran.worldediting.Element
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEditing
import robotran.worldediting.after

/**
 * Holds the edited world; null while it is not edited. Valid states are saved at once, so that a crash loses nothing.
 */
class WorldEditStateHolder(
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val runControls: RunControls,
    private val notices: Notices,
) {
    private var latest: WorldEditing? = null

    /** The world since a sensor was plugged in; null if none was. */
    private var plugged: World? = null

    var state: WorldEditState? by mutableStateOf(null)
        private set

    fun handle(event: WorldEditEvent) {
        when (event) {
            WorldEditEvent.EditorOpened -> open()
            is WorldEditEvent.Edited -> edit(event.edit)
            WorldEditEvent.EditorClosed -> close()
            WorldEditEvent.TriedOut -> if (close()) runControls.run()
            WorldEditEvent.HintsClosed -> state = state?.copy(hintsShown = false)
            is WorldEditEvent.SensorPluggedIn -> plugIn(event.robot, event.missing)
            WorldEditEvent.PlugUndone -> if (current.project.world == plugged) changeOutside(Edit.Undo)
            WorldEditEvent.EditsDiscarded -> discard()
        }
    }

    private fun open() {
        if (state != null) return
        val editing = lastEditing()
        state = WorldEditState(editing.after(Edit.Select(null)).after(Edit.FinishChange), editing.world)
    }

    /** The state to edit from: with groups and undo history if the world has not changed since the last edit. */
    private fun lastEditing(): WorldEditing {
        val world = current.project.world
        return latest?.takeIf { it.world == world } ?: WorldEditing.of(world)
    }

    private fun plugIn(robot: Int, missing: MissingSensor) {
        val place = current.project.world.robots.getOrNull(robot) ?: return
        val ports = place.ports.mapIndexed { port, plugged -> if (port == missing.port - 1) missing.plug else plugged }
        val edit = Edit.Change(ElementRef(ElementKind.ROBOT, robot), Element.OfRobot(place.copy(ports = ports)))
        if (!changeOutside(edit)) return
        plugged = current.project.world
        notices.show(Notice.SensorPluggedIn(missing.port))
    }

    /** Changes the world while the editor is closed, and starts a new run in it. Returns whether it has changed. */
    private fun changeOutside(edit: Edit): Boolean {
        if (state != null) return false
        val before = lastEditing()
        val editing = before.after(Edit.FinishChange).after(edit).after(Edit.FinishChange)
        latest = editing
        val isChanged = editing.world != before.world
        if (isChanged) editor.changeWorld(editing.world)
        return isChanged
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
