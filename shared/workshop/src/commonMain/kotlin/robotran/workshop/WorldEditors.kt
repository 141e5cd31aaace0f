package robotran.workshop

import kotlinx.coroutines.CoroutineScope
import robotran.robotediting.RobotEdit
import robotran.workshop.assignment.VariationTarget
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.platform.Platform
import robotran.workshop.robot.RobotEditStateHolder
import robotran.workshop.service.Preferences
import robotran.workshop.service.RunControls
import robotran.workshop.state.Notice
import robotran.workshop.state.NoticeAction
import robotran.workshop.state.RobotEditState
import robotran.workshop.state.WorldEditState
import robotran.workshop.worldedit.WorldEditStateHolder
import robotran.world.RobotDescription
import robotran.world.RobotPlacement
import robotran.world.robot.draftError
import robotran.worldediting.ElementKind

/**
 * The world editor and the workbench of robots: whether they may open, and what follows when they close.
 *
 * @param target the world or the variation that is edited.
 * @param isLocked whether the open assignment does not allow to change its world.
 * @param onOpening called before the world editor opens.
 * @param onClosed called when it is closed; `leadsBack` is false if its world is tried out now.
 */
internal class WorldEditors(
    platform: Platform,
    scope: CoroutineScope,
    preferences: Preferences,
    runControls: RunControls,
    private val board: NoticeStateHolder,
    private val target: VariationTarget,
    private val isLocked: () -> Boolean,
    private val onOpening: () -> Unit,
    private val onClosed: (leadsBack: Boolean) -> Unit,
) {
    private val worldEdit = WorldEditStateHolder(target, target, runControls, board, target::origin)
    private val robotEdit = RobotEditStateHolder(platform, scope, preferences, board, { worldEdit.state }, ::handle)

    val world: WorldEditState? get() = worldEdit.state
    val robot: RobotEditState? get() = robotEdit.state

    /** Whether what [action] undoes is still there; true for any other action. */
    fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.UnplugSensors -> worldEdit.canUndoPlug
        NoticeAction.BringRobotBack -> worldEdit.canBringBack
        else -> true
    }

    fun handle(event: WorldEditEvent) {
        val changesWorld = event == WorldEditEvent.EditorOpened ||
            event is WorldEditEvent.SensorsPluggedIn ||
            event is WorldEditEvent.PenbotChosen ||
            event is WorldEditEvent.RobotReplaced
        if (changesWorld && isLocked()) return board.show(Notice.WorldOfAssignment)
        if (event == WorldEditEvent.EditorOpened) onOpening()
        val wasOpen = worldEdit.state != null
        // Robots drive in the world itself, not in a variation of it.
        val isVariation = target.variation != null
        val edited = worldEdit.state?.world
        worldEdit.handle(if (isVariation && event == WorldEditEvent.TriedOut) WorldEditEvent.EditorClosed else event)
        if (!wasOpen || worldEdit.state != null) return
        if (isVariation) {
            board.dismissIf { it is Notice.RobotKeptAsDraft }
        } else if (event == WorldEditEvent.EditorClosed) {
            edited?.let(::draftError)?.let { board.show(Notice.RobotKeptAsDraft(it)) }
        }
        target.leave()
        onClosed(isVariation || event != WorldEditEvent.TriedOut)
    }

    fun handle(event: RobotEditEvent) {
        if (event is RobotEditEvent.BenchOpened) board.dismissIf { it.action is NoticeAction.BuildOn }
        robotEdit.handle(event)
    }

    /**
     * Puts an opened [robot] into the workbench, or otherwise in the place of the robot that is chosen, or of [shown].
     * Returns whether it is in the world now.
     */
    fun putRobot(robot: RobotDescription, shown: RobotPlacement): Boolean {
        if (robotEdit.state != null) {
            robotEdit.handle(RobotEditEvent.Edited(RobotEdit.Replace(robot)))
            return false
        }
        val chosen = worldEdit.state?.editing?.only?.takeIf { it.kind == ElementKind.ROBOT }
        val place = chosen?.let { worldEdit.state?.world?.robots?.getOrNull(it.number) } ?: shown
        handle(WorldEditEvent.RobotReplaced(place.name, robot))
        return true
    }

    /** Opens the world editor from the page of the assignment, for the world or a [variation] of it. */
    fun open(variation: Int?) {
        target.comeFromAssignment(variation)
        handle(WorldEditEvent.EditorOpened)
    }

    /** Closes both without a word. */
    fun leave() {
        robotEdit.leave()
        worldEdit.leave()
        target.leave()
    }
}
