package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.draw.drawWithContent
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.layout.LayoutCoordinates
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.learning.LessonPlace
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.TaskHelp
import robotran.workshop.state.TutorialState

/**
 * The task of a step, its status, and help. A bar on the left marks its extent.
 *
 * @param onPlaced where the text of the task is.
 */
@Composable
internal fun TutorialTask(
    state: LearningState,
    tutorial: TutorialState,
    onEvent: (LearningEvent) -> Unit,
    onPlaced: (LayoutCoordinates) -> Unit,
) {
    val colours = LocalRobotranColours.current
    val text = state.textOf(tutorial.current)
    val bar = if (state.isStepDone) RobotranColours.RUN_GREEN else RobotranColours.YELLOW
    Column(
        Modifier
            .fillMaxWidth()
            .testTag(LearningTags.TASK)
            .drawBehind {
                drawRoundRect(bar, size = Size(BAR.toPx(), size.height), cornerRadius = CornerRadius(BAR.toPx() / 2))
            }
            .padding(start = 16.dp),
        Arrangement.spacedBy(8.dp),
    ) {
        Row(
            Modifier.testTag(LearningTags.TASK_STATUS).semantics(mergeDescendants = true) {
                heading()
                liveRegion = LiveRegionMode.Polite
            },
            Arrangement.spacedBy(8.dp),
            Alignment.CenterVertically,
        ) {
            if (state.isStepDone) SmallIcon(DONE_ICON, colours.onPane)
            val title = if (state.isStepDone) LearningTexts::taskDone else LearningTexts::task
            Text(title(spoken), style = TextStyles.lead.strong)
        }
        MarkedText(text.task, Modifier.onGloballyPositioned(onPlaced))
        text.again?.takeIf { tutorial.place == LessonPlace.AGAIN }?.let {
            MarkedText(it, Modifier.testTag(LearningTags.AGAIN))
        }
        TaskHelps(
            tutorial.help,
            state.isInBlocks,
            state.isReached,
            { onEvent(LearningEvent.HintRequested(it)) },
            { onEvent(LearningEvent.SolutionRequested(it)) },
        )
    }
}

/**
 * Buttons for hints and the solution, and below them the visible hints, the latest first, in a column.
 *
 * @param isSolved whether the present run has solved the task, so that nobody needs help until the next one.
 */
@Composable
fun TaskHelps(
    help: TaskHelp,
    isInBlocks: Boolean,
    isSolved: Boolean,
    onHint: (shown: Boolean) -> Unit,
    onSolution: (shown: Boolean) -> Unit,
) {
    // Above their content, so that they do not move. In sight with the latest hint, for whoever wants another.
    val latest = help.hints.lastOrNull()
    Column(Modifier.broughtIntoSight(latest != null, latest), Arrangement.spacedBy(8.dp)) {
        if (!isSolved || help.solutionShown) Helps(help, onHint, onSolution)
        latest?.let { HintCards(listOf(it), isInBlocks) }
    }
    HintCards(help.hints.dropLast(1).reversed(), isInBlocks, hasLatest = false)
    if (help.solutionShown) {
        Text(
            LearningTexts.solutionNote(spoken),
            Modifier.testTag(LearningTags.SOLUTION_NOTE).broughtIntoSight(true).announced(),
            TextStyles.sentence,
            color = LocalRobotranColours.current.quiet,
        )
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Helps(help: TaskHelp, onHint: (Boolean) -> Unit, onSolution: (Boolean) -> Unit) {
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        val hintWords = listOf(LearningTexts::hint, LearningTexts::hintMore, LearningTexts::hintHide)
        val hintWord = if (help.nextStage == null) hintWords.lastIndex else minOf(help.hints.size, 1)
        Help(hintWords, hintWord, LearningTags.HINT_WANTED) { onHint(help.nextStage != null) }
        val solutionWords = listOf(LearningTexts::showMe, LearningTexts::backToMine)
        Help(solutionWords, if (help.solutionShown) 1 else 0, LearningTags.SOLUTION_WANTED) {
            onSolution(!help.solutionShown)
        }
    }
}

/** A button with the word at [index] of [labels], as wide as for the longest of them. */
@Composable
private fun Help(labels: List<Label>, index: Int, tag: String, onClick: () -> Unit) {
    val words = labels.map { it(spoken) }
    Box {
        for (word in words) Box(Modifier.drawWithContent { }.clearAndSetSemantics { }) { ButtonSize(word) }
        Button(words[index], tag, ButtonKind.SECOND, Modifier.matchParentSize(), onClick = onClick)
    }
}

private val BAR = 6.dp
