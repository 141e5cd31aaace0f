package robotran.workshop.worldedit

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import robotran.simulation.state.MissingSensors
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.service.CurrentProject
import robotran.workshop.service.Notices
import robotran.workshop.service.ProjectEditor
import robotran.workshop.service.RunControls
import robotran.workshop.state.EditOrigin
import robotran.workshop.state.Notice
import robotran.workshop.state.WorldEditState
import robotran.world.ReadyRobots
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing
import robotran.worldediting.after
import robotran.worldediting.goalsMetAtStart

/**
 * Holds the edited world; null while it is not edited. Valid states are saved at once, so that a crash loses nothing.
 */
class WorldEditStateHolder(
    private val current: CurrentProject,
    private val editor: ProjectEditor,
    private val runControls: RunControls,
    private val notices: Notices,
    private val origin: () -> EditOrigin? = { null },
) {
    private var latest: WorldEditing? = null

    /** The sensors that were plugged in last; null if none were or if they are out again. */
    private var plugged: RobotChange? = null

    /** The robot that was replaced last; null if none was or if it is back. */
    private var replaced: RobotChange? = null

    var state: WorldEditState? by mutableStateOf(null)
        private set

    /** Whether [WorldEditEvent.PlugUndone] has something to take out. */
    val canUndoPlug: Boolean get() = plugged?.undoOf(now.world) != null

    /** Whether [WorldEditEvent.RobotBroughtBack] has something to bring back. */
    val canBringBack: Boolean get() = replaced?.undoOf(now.world) != null

    private val now: WorldEditing get() = state?.editing ?: lastEditing()

    fun handle(event: WorldEditEvent) {
        when (event) {
            WorldEditEvent.EditorOpened -> open()
            is WorldEditEvent.Edited -> edit(event.edit)
            WorldEditEvent.EditorClosed -> close()
            WorldEditEvent.TriedOut -> if (close()) runControls.run()
            WorldEditEvent.HintsClosed -> state = state?.copy(hintsShown = false)
            is WorldEditEvent.SensorsPluggedIn -> plugIn(event.robot, event.missing)
            is WorldEditEvent.PenbotChosen -> replace(event.robot, ReadyRobots.defaultOf(event.brick))
            is WorldEditEvent.RobotReplaced -> replace(event.robot, event.description)
            WorldEditEvent.PlugUndone -> if (takeBack(plugged)) plugged = null
            WorldEditEvent.RobotBroughtBack -> if (takeBack(replaced)) replaced = null
            WorldEditEvent.EditsDiscarded -> discard()
        }
    }

    private fun open() {
        if (state != null) return
        val editing = lastEditing()
        state =
            WorldEditState(editing.after(WorldEdit.Select(null)).after(WorldEdit.FinishChange), editing.world, origin())
    }

    /** The state to edit from: with groups and undo history if the world has not changed since the last edit. */
    private fun lastEditing(): WorldEditing {
        val world = current.project.world
        return latest?.takeIf { it.world == world } ?: WorldEditing.of(world)
    }

    private fun replace(robot: String, description: RobotDescription) {
        replaced = change(robot) { Replacement(it, description) } ?: return
        notices.show(Notice.RobotReplaced(robot, description))
    }

    private fun plugIn(robot: String, missing: MissingSensors) {
        plugged = change(robot) { PlugChange(it, missing.sensors) } ?: return
        notices.show(Notice.SensorsPluggedIn(missing.sensors.map { it.label }))
    }

    /** Makes the change of the robot with this name; null if it changes nothing. */
    private fun change(robot: String, changeOf: (RobotPlacement) -> RobotChange): RobotChange? {
        val change = now.world.robots.find { it.name == robot }?.let(changeOf)
        return change?.takeIf { it.editOf(now.world)?.let(::changeAtOnce) == true }
    }

    /**
     * Takes back [change], by a step back in the history if that takes back nothing else, otherwise by a new step.
     * Returns whether it was there.
     */
    private fun takeBack(change: RobotChange?): Boolean {
        val edit = change?.undoOf(now.world) ?: return false
        val isLastStep = now.after(WorldEdit.Undo).world == now.after(edit).world
        changeAtOnce(if (isLastStep) WorldEdit.Undo else edit)
        return true
    }

    /**
     * Changes the world by a step of its own. While the editor is closed, this starts a new run, or opens the editor if
     * the world is invalid now, such as with a robot that has no room. Returns whether the world has changed.
     */
    private fun changeAtOnce(edit: WorldEdit): Boolean {
        val before = now
        val steps = listOf(WorldEdit.Drop, WorldEdit.FinishChange, edit, WorldEdit.FinishChange)
        if (state != null) {
            steps.forEach(::edit)
            return now.world != before.world
        }
        val editing = steps.fold(before, WorldEditing::after)
        val isChanged = editing.world != before.world
        if (isChanged && editing.errors.isNotEmpty()) {
            state = WorldEditState(editing, before.world, origin()).pointingOut(editing)
            return true
        }
        latest = editing
        if (isChanged) editor.changeWorld(editing.world)
        return isChanged
    }

    /** The same with the first error of [editing] in sight. */
    private fun WorldEditState.pointingOut(editing: WorldEditing): WorldEditState {
        val thing = editing.errors.firstOrNull()?.thing
        val shown = thing?.let { editing.after(WorldEdit.Select(it)) } ?: editing
        return copy(editing = shown, hasFailedToClose = true, hintsShown = true)
    }

    private fun edit(edit: WorldEdit) {
        val now = state ?: return
        val editing = now.editing.after(edit)
        val isMetNow = editing.world != now.world && goalsMetAtStart(editing.world) != now.metAtStart
        val hasNews = editing.error != null || editing.errors != now.editing.errors || isMetNow
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
        val editing = now.editing.after(WorldEdit.Drop)
        if (editing.errors.isNotEmpty()) {
            state = now.pointingOut(editing)
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
        plugged = null
        replaced = null
        state = null
    }

    private fun discard() {
        val now = state ?: return
        state = null
        if (current.project.world != now.first) editor.saveWorld(now.first)
    }
}
