package robotran.workshop.world

import robotran.robotediting.RobotEdit
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.robot.RobotEditStateHolder
import robotran.workshop.service.ProgramRoomEvent
import robotran.workshop.service.ProjectRoomEvent
import robotran.workshop.service.RoomEvent
import robotran.workshop.service.RunRoomEvent
import robotran.workshop.service.SchoolRoomEvent
import robotran.workshop.service.Services
import robotran.workshop.service.WindowRoomEvent
import robotran.workshop.service.WorldRoomEvent
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
            is ProjectRoomEvent.Leaving -> if (event.isAnother) leave()
            is WorldRoomEvent.EditorRequested -> open(event.variation)
            is WorldRoomEvent.RobotOpened -> if (putRobot(event.robot)) services.navigator.show(Pane.WORLD)
            is ProjectRoomEvent.Opened, is ProjectRoomEvent.WorldChanged, is ProjectRoomEvent.WorldSaved,
            is ProjectRoomEvent.RunSettingsChanged, ProjectRoomEvent.AssignmentChanged, ProjectRoomEvent.Touched,
            WorldRoomEvent.Edited, WorldRoomEvent.EditorOpening, is WorldRoomEvent.EditorClosed, is ProgramRoomEvent,
            is RunRoomEvent, is SchoolRoomEvent, is WindowRoomEvent,
            -> Unit
        }
    }

    /** Whether what [action] undoes is still there; true for any other action. */
    fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.UnplugSensors -> worldEdit.canUndoPlug
        NoticeAction.BringRobotBack -> worldEdit.canBringBack
        else -> true
    }

    fun handle(event: WorldEditEvent) {
        val before = services.current.world
        perform(event)
        if (services.current.world != before) services.publish(WorldRoomEvent.Edited)
    }

    /** What the workbench changes in the world comes back as a [WorldEditEvent]. */
    fun handle(event: RobotEditEvent) {
        if (event is RobotEditEvent.BenchOpened) notices.dismissIf { it.action is NoticeAction.BuildOn }
        robotEdit.handle(event)
    }

    private fun perform(event: WorldEditEvent) {
        val changesWorld = event == WorldEditEvent.EditorOpened ||
            event is WorldEditEvent.SensorsPluggedIn ||
            event is WorldEditEvent.PenbotChosen ||
            event is WorldEditEvent.RobotReplaced
        if (changesWorld && isLocked()) return notices.show(Notice.WorldOfAssignment)
        if (event == WorldEditEvent.EditorOpened) services.publish(WorldRoomEvent.EditorOpening)
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
        services.publish(WorldRoomEvent.EditorClosed(isVariation || event != WorldEditEvent.TriedOut))
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
