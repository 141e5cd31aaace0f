package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.simulation.state.GoalShortfall
import robotran.ui.assignment.HandInButton
import robotran.ui.assignment.Line
import robotran.ui.assignment.triesText
import robotran.ui.course.NextInCourse
import robotran.ui.drawer.ShortfallRow
import robotran.ui.run.texts.RunTexts
import robotran.ui.school.texts.LearningTexts
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.sheet.SheetColours
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.LearningPage
import robotran.workshop.state.OpenCourseTask
import robotran.workshop.state.SolvedTask
import robotran.workshop.state.WorkshopState

/**
 * What came of a run that is over, until it is closed: what was missing for the goals, or that the task is solved. Shown
 * at the end of the run only, so that an earlier time is not covered.
 *
 * @param canHandIn whether there is a sheet to hand in; false in a page embedded in another one.
 * @param tellsTries whether it says how far the pupil is with an assignment; false if another card does.
 */
@Composable
internal fun OutcomeCard(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    canHandIn: Boolean = true,
    tellsTries: Boolean = true,
) {
    val finished = state.run.outcome.finished ?: return
    var isClosed by remember(state.world, finished, state.run.outcome.goals) { mutableStateOf(false) }
    if (isClosed || state.run.isSeeking || state.run.time < finished) return
    val solved = state.learning.solved
    // What had not begun yet has nothing to say that the one before it does not.
    val missing = state.run.shortfalls.filterNot { it.shortfall == GoalShortfall.NotBegun }.take(MAX_SHOWN)
    val isTimeUp = state.run.isTimeUp
    when {
        solved != null -> Card(RobotranColours.RUN_GREEN, {
            isClosed = true
        }, modifier.testTag(ScreenTags.SOLVED_CARD)) {
            Solved(solved, state.assignment, state.course.open.takeIf { canHandIn }, canHandIn, tellsTries, onEvent)
        }

        missing.isNotEmpty() || isTimeUp -> Card(
            SheetColours.SHORTFALL,
            { isClosed = true },
            modifier.testTag(ScreenTags.MISSING_CARD),
        ) {
            Heading(RunTexts.outcomeMissing(spoken))
            if (isTimeUp) Line(RunTexts.timeUp(spoken, state.world.timeLimit), ScreenTags.MISSING_TIME_UP)
            for (mark in missing) ShortfallRow(mark, onEvent)
            state.assignment?.let { Tries(it, canHandIn = false, tellsTries, onEvent) }
            val hints = state.assignment?.hints ?: state.learning.worldTask?.help?.hints.orEmpty()
            if (!state.taskShown && hints.isNotEmpty()) {
                // The hint that fits is in the card of the task.
                Button(LearningTexts.hint(spoken), ScreenTags.MISSING_HINT, ButtonKind.SECOND) {
                    onEvent(ScreenEvent.TaskShown(true))
                }
            }
        }
    }
}

@Composable
private fun Solved(
    solved: SolvedTask,
    assignment: AssignmentState?,
    course: OpenCourseTask?,
    canHandIn: Boolean,
    tellsTries: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    Heading(RunTexts.outcomeSolved(spoken))
    for (line in solvedText(solved)) {
        Text(line, style = TextStyles.sentence)
    }
    when {
        assignment == null -> Next(solved, onEvent)
        course == null -> Tries(assignment, canHandIn, tellsTries, onEvent)

        else -> {
            Tries(assignment, canHandIn = false, tellsTries, onEvent)
            NextInCourse(course, onEvent) { HandInButton(assignment, ScreenTags.SOLVED_HAND_IN, onEvent) }
        }
    }
}

/** How far the pupil is with the assignment. */
@Composable
private fun Tries(
    assignment: AssignmentState,
    canHandIn: Boolean,
    tellsTries: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    if (!assignment.isOpenForTries) return
    if (tellsTries) Line(triesText(assignment.tries), ScreenTags.OUTCOME_TRIES)
    if (canHandIn) HandInButton(assignment, ScreenTags.SOLVED_HAND_IN, onEvent)
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Next(solved: SolvedTask, onEvent: (WorkshopEvent) -> Unit) {
    val next = solved.nextStep
    val worlds = LearningTexts.tryWorlds(spoken)
    val showWorlds = { onEvent(LearningEvent.PageRequested(LearningPage.WORLDS)) }
    FlowRow(Modifier.padding(top = 8.dp), Arrangement.spacedBy(8.dp), Arrangement.spacedBy(8.dp)) {
        for (harder in solved.harder) {
            val title = harder.world(LocalLanguage.current).title
            Button(LearningTexts.harder(spoken, title), ScreenTags.solved(harder.name)) {
                onEvent(LearningEvent.WorldChosen(harder.name))
            }
        }
        if (next != null) {
            Button(LearningTexts.next(spoken), ScreenTags.SOLVED_NEXT) {
                onEvent(LearningEvent.StepChosen(next))
                onEvent(LearningEvent.TutorialFolded(false))
            }
        } else if (solved.harder.isEmpty()) {
            Button(worlds, ScreenTags.SOLVED_WORLDS, onClick = showWorlds)
        } else {
            Button(worlds, ScreenTags.SOLVED_WORLDS, ButtonKind.SECOND, onClick = showWorlds)
        }
    }
}

@Composable
private fun Heading(text: String) = Text(text, Modifier.heading(), TextStyles.cardTitle.strong)

/** @param bar the colour of the bar at its left side. */
@Composable
private fun Card(bar: Color, onClose: () -> Unit, modifier: Modifier, content: @Composable () -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        modifier
            .clip(RoundedCornerShape(CORNER))
            .background(colours.pane)
            .border(1.dp, colours.line, RoundedCornerShape(CORNER))
            // Blocks touches on the content below.
            .pointerInput(Unit) { }
            // Above the fade of the text that scrolls.
            .drawWithContent {
                drawContent()
                drawRect(bar, size = Size(BAR.toPx(), size.height))
            },
        verticalAlignment = Alignment.Top,
    ) {
        val scroll = rememberScrollState()
        Column(
            Modifier
                .weight(1f)
                .scrollHint(scroll)
                .verticalScroll(scroll)
                .padding(start = 22.dp, top = 12.dp, bottom = 12.dp)
                .announced(),
            Arrangement.spacedBy(4.dp),
        ) { content() }
        IconButton(Icon.CLOSE, RunTexts.outcomeClose(spoken), ScreenTags.OUTCOME_CLOSE, onClick = onClose)
    }
}

/** The rest is in the goals. */
private const val MAX_SHOWN = 2
private val BAR = 6.dp
private val CORNER = Corners.MEDIUM
