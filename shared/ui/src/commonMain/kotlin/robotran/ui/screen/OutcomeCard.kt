package robotran.ui.screen

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
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
import robotran.workshop.event.RunEvent
import robotran.workshop.event.ScreenEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.AssignmentState
import robotran.workshop.state.DrawerTab
import robotran.workshop.state.LearningPage
import robotran.workshop.state.ShortfallMark
import robotran.workshop.state.SolvedTask
import robotran.workshop.state.WorkshopState

/**
 * What came of a run that is over, until it is closed: what was missing for the goals, that the task is solved, or that
 * the program works here and is to be tried elsewhere. Shown at the end of the run only, so that an earlier time is not
 * covered.
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
    // A goal may be met where the robot begins: before a run nobody has done anything.
    if (isClosed || state.untouched || state.run.isSeeking || state.run.time < finished) return
    val solved = state.learning.solved
    val elsewhere = state.learning.elsewhere
    val missing = missed(state.run.shortfalls)
    val isTimeUp = state.run.isTimeUp
    val onClose = { isClosed = true }
    when {
        solved != null -> Card(SolvedLook, onClose, modifier) {
            Onward(state, solved, canHandIn, tellsTries, onEvent)
            solved.learned?.let { Text(RunTexts.outcomeLearned(spoken, it), style = TextStyles.sentence) }
            Text(recordText(solved), style = TextStyles.smallLines, color = LocalRobotranColours.current.quiet)
        }

        elsewhere != null -> Card(SolvedHereLook, onClose, modifier) {
            TryElsewhere(state.learning, elsewhere, onEvent)
        }

        missing.isNotEmpty() || isTimeUp -> Card(missingLook(state.changed), onClose, modifier) {
            if (isTimeUp) Line(RunTexts.timeUp(spoken, state.world.timeLimit), ScreenTags.MISSING_TIME_UP)
            Missing(missing, onEvent)
            state.assignment?.let { Tries(it, canHandIn = false, tellsTries, onEvent) }
            Hint(state, onEvent)
        }
    }
}

/** Leads to the hint that fits, which is in the card of the task, unless that is open. */
@Composable
private fun Hint(state: WorkshopState, onEvent: (WorkshopEvent) -> Unit) {
    val hints = state.assignment?.hints ?: state.learning.worldTask?.help?.hints.orEmpty()
    val isTaskOpen = state.taskShown && (state.assignment != null || !state.taskFolded)
    if (isTaskOpen || hints.isEmpty()) return
    Button(LearningTexts.hint(spoken), ScreenTags.MISSING_HINT, ButtonKind.SECOND) {
        onEvent(ScreenEvent.TaskShown(true))
    }
}

/** The first that went wrong; the rest is behind it, in the goals. */
@Composable
private fun Missing(missing: List<ShortfallMark>, onEvent: (WorkshopEvent) -> Unit) {
    ShortfallRow(missing.firstOrNull() ?: return, onEvent)
    if (missing.size > 1) {
        Button(RunTexts.outcomeOthers(spoken), ScreenTags.MISSING_OTHERS, ButtonKind.SMALL_LINK) {
            onEvent(RunEvent.DrawerChosen(DrawerTab.GOALS))
        }
    }
}

/** The way on, once: the panel of a lesson has its own. */
@Composable
private fun Onward(
    state: WorkshopState,
    solved: SolvedTask,
    canHandIn: Boolean,
    tellsTries: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    val assignment = state.assignment
    val course = state.course.open.takeIf { canHandIn }
    val isLessonOpen = state.learning.tutorial?.isFolded == false
    when {
        assignment == null -> if (!isLessonOpen) Next(solved, onEvent)
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
    FlowRow(Modifier, Arrangement.spacedBy(Space.SMALL), Arrangement.spacedBy(Space.SMALL)) {
        if (next != null) {
            Button(LearningTexts.next(spoken), ScreenTags.SOLVED_NEXT) {
                onEvent(LearningEvent.StepChosen(next))
                onEvent(LearningEvent.TutorialFolded(false))
            }
        }
        solved.harder.forEachIndexed { place, harder ->
            val title = harder.world(LocalLanguage.current).title
            val kind = if (next == null && place == 0) ButtonKind.PRIMARY else ButtonKind.QUIET
            Button(LearningTexts.harder(spoken, title), ScreenTags.solved(harder.name), kind) {
                onEvent(LearningEvent.WorldChosen(harder.name))
            }
        }
        if (next == null) {
            val kind = if (solved.harder.isEmpty()) ButtonKind.PRIMARY else ButtonKind.QUIET
            Button(LearningTexts.tryWorlds(spoken), ScreenTags.SOLVED_WORLDS, kind) {
                onEvent(LearningEvent.PageRequested(LearningPage.WORLDS))
            }
        }
    }
}

/** @property bar the colour of the bar at its left side. */
private class CardLook(val title: Label, val bar: Color, val tag: String)

private val SolvedLook = CardLook(RunTexts::outcomeSolved, RobotranColours.RUN_GREEN, ScreenTags.SOLVED_CARD)
private val SolvedHereLook = CardLook(RunTexts::outcomeSolvedHere, RobotranColours.YELLOW, ScreenTags.ELSEWHERE_CARD)
private val MissingLook = CardLook(RunTexts::outcomeMissing, SheetColours.SHORTFALL, ScreenTags.MISSING_CARD)

/** @param isOfLastRun whether the program has been changed since, so that this says nothing about it. */
@Composable
private fun missingLook(isOfLastRun: Boolean): CardLook {
    if (!isOfLastRun) return MissingLook
    return CardLook(RunTexts::outcomeLastMissing, LocalRobotranColours.current.line, ScreenTags.MISSING_CARD)
}

@Composable
private fun Card(look: CardLook, onClose: () -> Unit, modifier: Modifier, content: @Composable () -> Unit) {
    val colours = LocalRobotranColours.current
    Column(
        modifier
            .testTag(look.tag)
            .clip(Shapes.MEDIUM)
            .background(colours.pane)
            .border(1.dp, colours.line, Shapes.MEDIUM)
            .drawWithContent {
                drawContent()
                drawRect(look.bar, size = Size(BAR.toPx(), size.height))
            }
            .padding(start = 22.dp, bottom = Space.MEDIUM)
            .announced(),
    ) {
        WordsBeside({
            IconButton(Icon.CLOSE, RunTexts.outcomeClose(spoken), ScreenTags.OUTCOME_CLOSE, onClick = onClose)
        }) {
            Text(
                look.title(spoken),
                Modifier.testTag(ScreenTags.OUTCOME_TITLE).padding(vertical = Space.TINY).heading(),
                TextStyles.cardTitle.strong,
            )
        }
        Column(Modifier.padding(end = Space.MEDIUM), Arrangement.spacedBy(Space.TINY)) { content() }
    }
}

private val BAR = 6.dp
