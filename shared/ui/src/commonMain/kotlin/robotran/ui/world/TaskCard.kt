package robotran.ui.world

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.gestures.Orientation
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import org.jetbrains.compose.resources.stringResource
import robotran.simulation.state.GoalProgress
import robotran.ui.assignment.AssignmentButtons
import robotran.ui.assignment.AssignmentCard
import robotran.ui.assignment.FeedbackCard
import robotran.ui.assignment.HandInLine
import robotran.ui.course.CourseLine
import robotran.ui.learning.HintCards
import robotran.ui.parts.Icon
import robotran.ui.parts.IconTouch
import robotran.ui.parts.scrollHint
import robotran.ui.resources.Res
import robotran.ui.resources.task_hide
import robotran.ui.theme.Corners
import robotran.ui.theme.LineHeights
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.ui.theme.TextSizes
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.LearningState
import robotran.workshop.state.OpenCourseTask
import robotran.world.World

/**
 * The title and the task of [world], until it is closed; a long task scrolls. In a world of the gallery, also the help
 * with its task, and in an assignment all about that.
 *
 * @param canHandIn whether there is a sheet to hand in; false in a page embedded in another one.
 * @param course where the assignment is in its course; null if it is in none.
 */
@Composable
internal fun TaskCard(
    world: World,
    learning: LearningState,
    assignment: AssignmentState?,
    goals: List<GoalProgress>,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    canHandIn: Boolean = true,
    course: OpenCourseTask? = null,
) {
    val colours = LocalRobotranColours.current
    Row(
        modifier
            .testTag("task-card")
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(1.dp, colours.line, RoundedCornerShape(CORNER))
            // Blocks touches on the content below.
            .pointerInput(Unit) { }
            .drawBehind { drawRect(RobotranColours.YELLOW, size = Size(BAR.toPx(), size.height)) },
        verticalAlignment = Alignment.Top,
    ) {
        val scroll = rememberScrollState()
        // With large text they would leave no room.
        val areButtonsFixed = LocalDensity.current.fontScale <= LARGE
        Column(Modifier.weight(1f)) {
            Column(
                Modifier
                    .weight(1f, fill = false)
                    .scrollHint(scroll, Orientation.Vertical, colours.pane, colours.onPane)
                    .verticalScroll(scroll)
                    .padding(start = 22.dp, top = 12.dp, bottom = 12.dp),
                Arrangement.spacedBy(4.dp),
            ) {
                Text(
                    world.title,
                    Modifier.testTag("task-title").semantics { heading() },
                    color = colours.onPane,
                    fontSize = TextSizes.LEAD,
                    lineHeight = LineHeights.BODY,
                    fontWeight = FontWeight.SemiBold,
                )
                assignment?.let { HintCards(it.hints, learning.isInBlocks) }
                assignment?.handIn?.let { HandInLine(it) }
                assignment?.feedback?.let { FeedbackCard(it) }
                Text(
                    world.task.trim(),
                    Modifier.fillMaxWidth().testTag("task-text").semantics { liveRegion = LiveRegionMode.Polite },
                    color = colours.onPane,
                    fontSize = TextSizes.BODY,
                    lineHeight = LineHeights.BODY,
                )
                assignment?.let { AssignmentCard(it, goals) }
                if (assignment != null && canHandIn && !areButtonsFixed) AssignmentButtons(assignment, onEvent)
                course?.let { CourseLine(it, onEvent) }
                learning.worldTask?.let { WorldTaskHelp(it, learning.isInBlocks, onEvent) }
            }
            if (assignment != null && canHandIn && areButtonsFixed) {
                AssignmentButtons(assignment, onEvent, Modifier.padding(start = 22.dp, bottom = 12.dp))
            }
        }
        IconTouch(Icon.CLOSE, stringResource(Res.string.task_hide), "task-hide", {
            onEvent(WorkshopEvent.TaskShown(false))
        })
    }
}

/** Up to this font scale there is room for fixed buttons. */
private const val LARGE = 1.3f
private val BAR = 6.dp
private val CORNER = Corners.MEDIUM
