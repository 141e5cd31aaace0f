package robotran.ui.robot

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.focusable
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.onKeyEvent
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.layout.boundsInRoot
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.editing.RobotTexts
import robotran.ui.sheet.RobotPlan
import robotran.uikit.*
import robotran.world.RobotColour

/** The robot from above, to be changed by touch, mouse and keys. Screen readers announce what is chosen. */
@Composable
internal fun RobotPlanCanvas(
    scope: RobotScope,
    view: PlanView,
    colour: RobotColour,
    focus: FocusRequester,
    modifier: Modifier = Modifier,
) {
    val colours = LocalRobotranColours.current
    val plan = remember(scope.robot) { RobotPlan(scope.robot) }
    val measurer = rememberTextMeasurer()
    val latest = rememberUpdatedState(scope)
    val name = RobotTexts.plan(spoken)
    val chosen = chosenText(scope.editing)
    Canvas(
        modifier
            .fillMaxSize()
            .testTag("robot-plan")
            .focusRing(isInside = true)
            .onGloballyPositioned { view.window = it.boundsInRoot() }
            .semantics {
                contentDescription = name
                stateDescription = chosen
                liveRegion = LiveRegionMode.Polite
            }
            .focusRequester(focus)
            .onKeyEvent { event -> robotEditForKey(event, latest.value.editing)?.let { latest.value.make(it) } != null }
            .focusable()
            .pointerInput(view) { buildByTouch(view, { latest.value }, { focus.requestFocus() }) }
            .pointerInput(view) { zoomPlanByWheel(view) }
            .clipToBounds(),
    ) {
        if (view.window.isEmpty) return@Canvas
        drawPlan(scope.editing, plan, colour, view.transform, measurer, colours)
    }
    LaunchedEffect(focus) { focus.requestFocus() }
}
