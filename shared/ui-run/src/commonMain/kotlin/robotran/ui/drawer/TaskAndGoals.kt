package robotran.ui.drawer

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.toggleable
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.simulation.state.GoalProgress
import robotran.ui.run.tags.RunTags
import robotran.ui.run.texts.RunTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent

/**
 * Buttons for the task and the goals of the world, if it has them.
 *
 * @param isSlim whether there is room for one short line only.
 * @param hasName whether that line may say that it counts goals.
 * @param howFar how far the pupil is with an assignment, for screen readers.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun TaskAndGoals(
    hasTask: Boolean,
    taskShown: Boolean,
    goals: List<GoalProgress>,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    isSlim: Boolean = false,
    howFar: String = "",
    hasName: Boolean = true,
) {
    FlowRow(modifier, Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        if (hasTask) TaskChip(taskShown, howFar) { onEvent(ScreenEvent.TaskShown(it)) }
        GoalChip(goals, onEvent, isSlim = isSlim, hasName = hasName)
    }
}

/** Shows and hides the task of the world. */
@Composable
private fun TaskChip(shown: Boolean, howFar: String, onShow: (Boolean) -> Unit) {
    val colours = LocalRobotranColours.current
    val help = if (shown) CommonTexts.taskHide(spoken) else RunTexts.taskShow(spoken)
    Box(
        Modifier
            .testTag(RunTags.TASK_CHIP)
            .focusRing(CORNER)
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(BorderStroke(1.dp, if (shown) colours.onPane else colours.line), RoundedCornerShape(CORNER))
            .toggleable(shown, role = Role.Button, onValueChange = onShow)
            .defaultMinSize(minHeight = Dimensions.TARGET)
            .padding(horizontal = 16.dp, vertical = 8.dp)
            .semantics(mergeDescendants = true) {
                contentDescription = "$help. $howFar".removeSuffix(". ")
            },
        Alignment.Center,
    ) {
        Text(RunTexts.task(spoken), style = TextStyles.tightLabel.medium)
    }
}

private val CORNER = Corners.SHEET
