package robotran.workshop

import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.NoticeAction

/** What the buttons of notices do in the [rooms]. */
internal class NoticeActions(private val rooms: Rooms) {
    /** Whether an undo that a notice offers is still possible. */
    fun canUndo(action: NoticeAction): Boolean = when (action) {
        NoticeAction.BeginningUndone -> rooms.school.assignment.canUndoBeginning
        else -> rooms.world.editors.canUndo(action)
    }

    fun perform(action: NoticeAction) = with(rooms) {
        when (action) {
            NoticeAction.ShowProjects -> document.handle(DocumentEvent.ProjectListRequested)
            is NoticeAction.GoBack -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            is NoticeAction.GoOn -> document.handle(DocumentEvent.SavedProjectChosen(action.project))
            NoticeAction.ChangeNumber -> programs.editFirstLength()
            NoticeAction.BackToHandIns -> school.handIns.goBack()
            NoticeAction.BeginningUndone -> school.handle(AssignmentEvent.BeginningUndone)
            NoticeAction.UnplugSensors -> world.handle(WorldEditEvent.PlugUndone)
            NoticeAction.BringRobotBack -> world.handle(WorldEditEvent.RobotBroughtBack)
            is NoticeAction.BuildOn -> world.handle(RobotEditEvent.BenchOpened(action.robot))
        }
    }
}
