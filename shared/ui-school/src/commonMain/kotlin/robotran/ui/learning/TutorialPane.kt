package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ColumnScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.saveable.rememberSaveable
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.TutorialState

/**
 * The current step of the tutorial, above the program or in its place: first the task, which is always there, below or
 * beside it how it works. Both scroll; the way through the lessons stays visible.
 *
 * @param onProgram shows the program, which the lesson is in the place of; null if the program is beside it.
 */
@Composable
fun TutorialPane(
    state: LearningState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    onProgram: (() -> Unit)? = null,
) {
    val tutorial = state.tutorial ?: return
    val colours = LocalRobotranColours.current
    val title = LearningTexts.tutorial(spoken)
    BoxWithConstraints(
        modifier.background(colours.pane).testTag(LearningTags.TUTORIAL).semantics {
            paneTitle = title
        },
    ) {
        val scale = LocalDensity.current.fontScale
        val isBroad = maxWidth >= BROAD * scale
        val isTall = maxHeight >= TALL * scale
        Column(Modifier.fillMaxSize()) {
            TutorialStrip(state, onEvent)
            HorizontalDivider()
            key(tutorial.step) {
                if (isBroad) {
                    TaskAndText(state, tutorial, onEvent, Modifier.weight(1f))
                } else {
                    TaskOverText(state, tutorial, isTall, onEvent, Modifier.weight(1f))
                }
            }
            HorizontalDivider()
            TutorialFoot(tutorial, state.isStepDone && state.elsewhere == null, onEvent, onProgram)
        }
    }
}

@Composable
private fun TaskAndText(
    state: LearningState,
    tutorial: TutorialState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
) = Row(modifier.fillMaxSize()) {
    TaskStays(taskOf(state, tutorial), Modifier.weight(1f)) { onPlaced ->
        Scrolled(LearningTags.TASK_AND_HELP, Modifier) {
            if (LocalDensity.current.fontScale <= LARGE_LESSON) StepTitle(state, tutorial)
            TutorialTask(state, tutorial, onEvent, onPlaced)
        }
    }
    Scrolled(LearningTags.TUTORIAL_TEXT, Modifier.weight(1f)) { Paragraphs(state, tutorial) }
}

/** @param isTall whether there is room for both, so that the text needs no unfolding. */
@Composable
private fun TaskOverText(
    state: LearningState,
    tutorial: TutorialState,
    isTall: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
) = TaskStays(taskOf(state, tutorial), modifier) { onPlaced ->
    Scrolled(LearningTags.TUTORIAL_TEXT, Modifier) {
        var isOpen by rememberSaveable(tutorial.isLoaded, isTall) { mutableStateOf(isTall || !tutorial.isLoaded) }
        if (LocalDensity.current.fontScale <= LARGE_LESSON) StepTitle(state, tutorial)
        TutorialTask(state, tutorial, onEvent, onPlaced)
        Disclosure(LearningTexts.explanation(spoken), LearningTags.EXPLANATION, isOpen) { isOpen = it }
        if (isOpen) Paragraphs(state, tutorial)
    }
}

private fun taskOf(state: LearningState, tutorial: TutorialState): String = state.textOf(tutorial.current).task

@Composable
private fun Scrolled(tag: String, modifier: Modifier, content: @Composable ColumnScope.() -> Unit) {
    val scroll = rememberScrollState()
    Column(
        modifier
            .fillMaxSize()
            .testTag(tag)
            .scrollHint(scroll)
            .verticalScroll(scroll)
            .padding(horizontal = Space.LARGE, vertical = Space.MEDIUM),
        Arrangement.spacedBy(Space.SMALL),
        content = content,
    )
}

@Composable
private fun StepTitle(state: LearningState, tutorial: TutorialState) = Text(
    state.textOf(tutorial.current).title,
    Modifier.testTag(LearningTags.STEP_TITLE).heading(),
    TextStyles.cardTitle.strong,
    color = LocalRobotranColours.current.onPane,
)

@Composable
private fun Paragraphs(state: LearningState, tutorial: TutorialState) = Column(
    Modifier.testTag(LearningTags.EXPLANATION_TEXT),
    Arrangement.spacedBy(Space.SMALL),
) {
    for (paragraph in state.textOf(tutorial.current).paragraphs) MarkedText(paragraph)
}

/** From this width on, at default font size, the task is next to the text. */
private val BROAD = 640.dp

/** From this height on, at default font size, there is room for a task and its text. */
private val TALL = 480.dp
