package robotran.workshop.world

import robotran.robotediting.RobotEdit
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.robot.RobotEditStateHolder
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.Services
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction
import robotran.workshop.state.Pane
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState
import robotran.workshop.worldedit.WorldEditStateHolder
import robotran.world.RobotDescription
import robotran.world.robot.draftError
import robotran.worldediting.ElementKind

/**
 * The world editor and the workbench of robots: whether they may open, and what follows when they close.
 *
 * @param isLocked whether the open assignment does not allow to change its world.
 */
internal class WorldEditors(private val services: Services, private val isLocked: () -> Boolean) {
    private val target = with(services) { VariationTarget(current, editor, assignments) }
    private val notices = services.notices
    private val worldEdit = WorldEditStateHolder(target, target, services.runControls, notices, target::origin)
    private val robotEdit: RobotEditStateHolder = with(services) {
        RobotEditStateHolder(platform, scope, preferences, notices, { worldEdit.state }, ::handle)
    }

    val world: WorldEditState? get() = worldEdit.state
    val robot: RobotEditState? get() = robotEdit.state

    fun on(event: RoomEvent) {
        when (event) {
            is RoomEvent.ProjectLeaving -> if (event.isAnother) leave()
            is RoomEvent.WorldEditorRequested -> open(event.variation)
            is RoomEvent.RobotOpened -> if (putRobot(event.robot)) services.navigator.show(Pane.WORLD)
            else -> Unit
        }
    }

    /** Whether what [action] undoes is still there; true for any other action. */
    fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.UnplugSensors -> worldEdit.canUndoPlug
        NoticeAction.BringRobotBack -> worldEdit.canBringBack
        else -> true
    }

    fun handle(event: WorldEditEvent): Unit = edit { perform(event) }

    fun handle(event: RobotEditEvent): Unit = edit {
        if (event is RobotEditEvent.BenchOpened) notices.dismissIf { it.action is NoticeAction.BuildOn }
        robotEdit.handle(event)
    }

    private fun edit(change: () -> Unit) {
        val before = services.current.world
        change()
        if (services.current.world != before) services.publish(RoomEvent.WorldEdited)
    }

    private fun perform(event: WorldEditEvent) {
        val changesWorld = event == WorldEditEvent.EditorOpened ||
            event is WorldEditEvent.SensorsPluggedIn ||
            event is WorldEditEvent.PenbotChosen ||
            event is WorldEditEvent.RobotReplaced
        if (changesWorld && isLocked()) return notices.show(Notice.WorldOfAssignment)
        if (event == WorldEditEvent.EditorOpened) services.publish(RoomEvent.WorldEditorOpening)
        val wasOpen = worldEdit.state != null
        // Robots drive in the world itself, not in a variation of it.
        val isVariation = target.variation != null
        val edited = worldEdit.state?.world
        worldEdit.handle(if (isVariation && event == WorldEditEvent.TriedOut) WorldEditEvent.EditorClosed else event)
        if (!wasOpen || worldEdit.state != null) return
        if (isVariation) {
            notices.dismissIf { it is Notice.RobotKeptAsDraft }
        } else if (event == WorldEditEvent.EditorClosed) {
            edited?.let(::draftError)?.let { notices.show(Notice.RobotKeptAsDraft(it)) }
        }
        target.leave()
        services.publish(RoomEvent.WorldEditorClosed(isVariation || event != WorldEditEvent.TriedOut))
    }

    /**
     * Puts an opened [robot] into the workbench, or otherwise in the place of the robot that is chosen, or of the one whose
     * programs are shown.
     * Returns whether it is in the world now.
     */
    private fun putRobot(robot: RobotDescription): Boolean {
        if (robotEdit.state != null) {
            robotEdit.handle(RobotEditEvent.Edited(RobotEdit.Replace(robot)))
            return false
        }
        val chosen = worldEdit.state?.editing?.only?.takeIf { it.kind == ElementKind.ROBOT }
        val place = chosen?.let { worldEdit.state?.world?.robots?.getOrNull(it.number) } ?: services.current.shownRobot
        handle(WorldEditEvent.RobotReplaced(place.name, robot))
        return true
    }

    /** Opens the world editor from the page of the assignment, for the world or a [variation] of it. */
    private fun open(variation: Int?) {
        target.comeFromAssignment(variation)
        handle(WorldEditEvent.EditorOpened)
    }

    /** Closes both without a word. */
    private fun leave() {
        robotEdit.leave()
        worldEdit.leave()
        target.leave()
    }
}
