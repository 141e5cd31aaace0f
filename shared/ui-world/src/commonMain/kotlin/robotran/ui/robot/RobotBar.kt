package robotran.ui.robot

import androidx.compose.runtime.Composable
import robotran.editing.RobotTexts
import robotran.ui.editing.BarToggle
import robotran.ui.editing.BarTool
import robotran.ui.editing.EditorBar
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.RobotEditEvent

/** The top of the workbench. */
@Composable
internal fun RobotBar(scope: RobotScope, view: PlanView, isOnSheet: Boolean, withWords: Boolean) = EditorBar(
    WorldTags.ROBOT,
    scope,
    scope.editing.history,
    withWords,
    onDone = { scope.perform(RobotEditEvent.BenchClosed) },
) {
    BarToggle(ON_SHEET, RobotTexts.onSheet(spoken), WorldTags.ROBOT_ON_SHEET, isOnSheet, withWords) {
        scope.perform(RobotEditEvent.SheetShown(!isOnSheet))
    }
    BarTool(EditIcons.GROUP, RobotTexts.fit(spoken), WorldTags.ROBOT_FIT, withWords) { view.fit(scope.robot) }
}

/** A robot on a sheet of paper. */
private val ON_SHEET = Icon.strokes("M3 4H21V20H3V4", "M8 9H14V15H8V9", "M14 12H18")
