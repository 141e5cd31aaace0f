package robotran.ui.robot

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.editing.RobotTexts
import robotran.ui.editing.CanvasWords
import robotran.ui.editing.EditorCanvas
import robotran.ui.sheet.RobotPlan
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.world.RobotColour

/** The robot from above, to be changed by touch, mouse and keys. Screen readers announce what is chosen. */
@Composable
internal fun RobotPlanCanvas(scope: RobotScope, view: PlanView, colour: RobotColour, focus: FocusRequester) {
    val colours = LocalRobotranColours.current
    val plan = remember(scope.robot) { RobotPlan(scope.robot) }
    val measurer = rememberTextMeasurer()
    val words =
        CanvasWords(WorldTags.ROBOT_PLAN, RobotTexts.plan(spoken), chosenText(scope.editing), hasRingInside = true)
    EditorCanvas(
        words,
        scope,
        view,
        focus,
        onKey = { robotEditForKey(it, scope.editing) },
        follow = { latest, down -> buildByFinger(view, latest, down) },
    ) { drawPlan(scope.editing, plan, colour, view.transform, measurer, colours) }
}
