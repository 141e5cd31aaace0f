package robotran.ui.screen

import robotran.ui.robot.escapedRobot
import robotran.ui.worldedit.escaped
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.CourseEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RobotEditEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.SettingsEvent
import robotran.workshop.event.SheetEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.Pane
import robotran.workshop.state.WorkshopState

/** The pages over the workshop that Back closes, topmost first. Menus and dialogs handle Back themselves. */
fun pageBackEvents(state: WorkshopState): List<WorkshopEvent> = buildList {
    if (state.settingsShown) add(SettingsEvent.SettingsShown(false))
    state.handIns?.let { handIns ->
        if (handIns.isScanning) add(HandInsEvent.ScanEnded)
        if (handIns.openedRow != null) add(HandInsEvent.HandInChosen(null))
        add(HandInsEvent.Closed)
    }
    if (state.making != null) add(AssignmentEvent.MakingClosed)
    if (state.course.page != null) add(CourseEvent.PageClosed)
    if (state.learning.page != null) add(LearningEvent.PageClosed)
    state.robotEdit?.let { bench ->
        escapedRobot(bench.editing)?.let { add(RobotEditEvent.Edited(it)) }
        add(RobotEditEvent.BenchClosed)
    }
    state.worldEdit?.let { edit ->
        escaped(edit.editing)?.let { add(WorldEditEvent.Edited(it)) }
        add(WorldEditEvent.EditorClosed)
    }
}

/**
 * What Back closes in the workshop itself. On screens with room for only one pane, it returns to the world. Empty if
 * Back leaves the app.
 */
internal fun paneBackEvents(state: WorkshopState, isWide: Boolean): List<WorkshopEvent> = buildList {
    if (state.sheet.words != null) add(SheetEvent.WordsChanged(null))
    if (!isWide) {
        if (state.learning.tutorial?.isFolded == false) add(LearningEvent.TutorialFolded(true))
        if (state.pane != Pane.WORLD) add(ScreenEvent.PaneChosen(Pane.WORLD))
    }
    if (isWide && state.fullPane != null) add(ScreenEvent.PaneFilled(null))
    if (state.run.drawer.tab != null) add(RunEvent.DrawerChosen(null))
}
