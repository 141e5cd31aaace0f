package robotran.ui.task

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import robotran.simulation.state.GoalProgress
import robotran.ui.assignment.AssignmentButtons
import robotran.ui.assignment.AssignmentCard
import robotran.ui.assignment.FeedbackCard
import robotran.ui.assignment.Goals
import robotran.ui.assignment.HandInButton
import robotran.ui.assignment.HandInLine
import robotran.ui.assignment.HandedInLine
import robotran.ui.assignment.Line
import robotran.ui.assignment.triesText
import robotran.ui.course.CourseLine
import robotran.ui.learning.FOLD_ICON
import robotran.ui.learning.HintCards
import robotran.ui.learning.UNFOLD_ICON
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.LearningTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.LearningState
import robotran.workshop.state.OpenCourseTask
import robotran.world.World

/**
 * What there is to do in [world].
 *
 * @property assignment the assignment that the task is of; null if it is of none.
 * @property canHandIn whether there is a sheet to hand in; false in a page embedded in another one.
 * @property course where the assignment is in its course; null if it is in none.
 */
class OpenTask(
    val world: World,
    val learning: LearningState,
    val assignment: AssignmentState?,
    val goals: List<GoalProgress>,
    val canHandIn: Boolean,
    val course: OpenCourseTask?,
)

/**
 * The title and the text of [task], until it is closed; a long task scrolls. In a world of the gallery, also the help
 * with its task, and in an assignment all about that.
 *
 * @param isFolded whether only the title is shown and, of an assignment, the goals.
 * @param areButtonsFixed whether there is room for buttons that do not scroll.
 */
@Composable
fun TaskCard(
    task: OpenTask,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    isFolded: Boolean = false,
    areButtonsFixed: Boolean = true,
) {
    val assignment = task.assignment
    val colours = LocalRobotranColours.current
    Column(
        modifier
            .testTag(AssignmentTags.TASK_CARD)
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(1.dp, colours.line, RoundedCornerShape(CORNER))
            // Blocks touches on the content below.
            .pointerInput(Unit) { }
            // Above the fade of the text that scrolls.
            .drawWithContent {
                drawContent()
                drawRect(RobotranColours.YELLOW, size = Size(BAR.toPx(), size.height))
            },
    ) {
        // It does not scroll, and must leave room for the rest.
        val lines = if (LocalDensity.current.fontScale <= LARGE) 2 else 1
        val fold = {
            val change = !isFolded
            onEvent(if (assignment == null) ScreenEvent.TaskFolded(change) else AssignmentEvent.TaskFolded(change))
        }
        WordsBeside({
            IconButton(
                if (isFolded) UNFOLD_ICON else FOLD_ICON,
                if (isFolded) LearningTexts.taskUnfold(spoken) else LearningTexts.taskFold(spoken),
                AssignmentTags.TASK_FOLD,
                onClick = fold,
            )
            HideTask(onEvent)
        }) {
            val touch = if (isFolded) Modifier.clickable(onClick = fold) else Modifier
            val air = if (isFolded) Space.TINY else Space.MEDIUM
            Title(task.world, touch.padding(start = START, top = air, bottom = air), lines)
        }
        when {
            assignment == null -> if (!isFolded) TaskOfWorld(task.world, task.learning, onEvent)
            isFolded -> FoldedAssignment(task, assignment, onEvent)
            else -> WholeAssignment(task, assignment, areButtonsFixed, onEvent)
        }
    }
}

@Composable
private fun HideTask(onEvent: (WorkshopEvent) -> Unit) =
    IconButton(Icon.CLOSE, CommonTexts.taskHide(spoken), AssignmentTags.TASK_HIDE) {
        onEvent(ScreenEvent.TaskShown(false))
    }

@Composable
private fun ColumnScope.TaskOfWorld(world: World, learning: LearningState, onEvent: (WorkshopEvent) -> Unit) =
    Scrolling {
        TaskText(world)
        learning.worldTask?.let { WorldTaskHelp(it, learning.isInBlocks, learning.solved != null, onEvent) }
    }

/** A hint that has just come, the goals, the tries and handing in, so that the world can be seen. */
@Composable
private fun ColumnScope.FoldedAssignment(
    task: OpenTask,
    assignment: AssignmentState,
    onEvent: (WorkshopEvent) -> Unit,
) = Scrolling {
    HintCards(assignment.hints.asReversed(), task.learning.isInBlocks)
    Goals(task.goals)
    if (task.canHandIn) Line(triesText(assignment.tries), AssignmentTags.ASSIGNMENT_TRIES, isNews = true)
    HandedInLine(assignment)
    // After a try it is one touch away; before, there is nothing to hand in.
    if (task.canHandIn && assignment.isOpenForTries && assignment.tries.tries > 0) {
        HandInButton(assignment, AssignmentTags.ASSIGNMENT_HAND_IN, onEvent)
    }
}

@Composable
private fun ColumnScope.WholeAssignment(
    task: OpenTask,
    assignment: AssignmentState,
    hasRoom: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val learning = task.learning
    // With large text they would leave no room.
    val areButtonsFixed = hasRoom && LocalDensity.current.fontScale <= LARGE
    Scrolling {
        HintCards(assignment.hints.asReversed(), learning.isInBlocks)
        assignment.handIn?.let { HandInLine(it) }
        assignment.feedback?.let { FeedbackCard(it, assignment.isProgramHandedIn) }
        TaskText(task.world)
        AssignmentCard(assignment, task.goals, onEvent)
        if (task.canHandIn && !areButtonsFixed) AssignmentButtons(assignment, onEvent)
        task.course?.let { CourseLine(it, onEvent) }
        learning.worldTask?.let { WorldTaskHelp(it, learning.isInBlocks, learning.solved != null, onEvent) }
    }
    if (task.canHandIn && areButtonsFixed) {
        AssignmentButtons(assignment, onEvent, Modifier.padding(start = START, bottom = 12.dp))
    }
}

@Composable
private fun TaskText(world: World) = Text(
    world.task.trim(),
    Modifier.fillMaxWidth().testTag(AssignmentTags.TASK_TEXT).announced(),
    TextStyles.sentence,
)

@Composable
private fun ColumnScope.Scrolling(content: @Composable ColumnScope.() -> Unit) {
    val scroll = rememberScrollState()
    Column(
        Modifier
            .weight(1f, fill = false)
            .scrollHint(scroll)
            .verticalScroll(scroll)
            .padding(start = START, bottom = 12.dp, end = 12.dp),
        Arrangement.spacedBy(4.dp),
        content = content,
    )
}

@Composable
private fun Title(world: World, modifier: Modifier = Modifier, maxLines: Int = Int.MAX_VALUE) = Text(
    world.title,
    modifier.testTag(AssignmentTags.TASK_TITLE).heading(),
    TextStyles.cardTitle.strong,
    maxLines = maxLines,
    overflow = TextOverflow.Ellipsis,
)

/** Up to this font scale there is room for fixed buttons. */
private const val LARGE = 1.3f
private val BAR = 6.dp
private val START = 22.dp
private val CORNER = Corners.MEDIUM
