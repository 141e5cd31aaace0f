package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningState
import robotran.workshop.state.TutorialState

/**
 * The current step of the tutorial: its text, program and task. It is next to the program, above it, or in its place.
 * The text scrolls; the actions below it stay visible.
 */
@Composable
fun TutorialPane(state: LearningState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val tutorial = state.tutorial ?: return
    val colours = LocalRobotranColours.current
    val title = LearningTexts.tutorial(spoken)
    BoxWithConstraints(
        modifier.background(colours.pane).testTag(LearningTags.TUTORIAL).semantics {
            paneTitle = title
        },
    ) {
        val isBroad = maxWidth >= BROAD * LocalDensity.current.fontScale
        val maxFoot = maxHeight * FOOT_SHARE
        Column(Modifier.fillMaxSize()) {
            TutorialStrip(state, onEvent)
            HorizontalDivider()
            key(tutorial.step) { Step(state, tutorial, isBroad, onEvent, Modifier.weight(1f)) }
            HorizontalDivider()
            TutorialFoot(tutorial, state.isStepDone, isBroad, maxFoot, onEvent)
        }
    }
}

@Composable
private fun Step(
    state: LearningState,
    tutorial: TutorialState,
    isBroad: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
) {
    val scroll = rememberScrollState()
    val scrolled = modifier
        .fillMaxSize()
        .testTag(LearningTags.TUTORIAL_TEXT)
        .scrollHint(scroll)
        .verticalScroll(scroll)
        .padding(horizontal = 20.dp, vertical = 16.dp)
    if (isBroad) {
        Row(scrolled, Arrangement.spacedBy(24.dp)) {
            Column(Modifier.weight(1f), Arrangement.spacedBy(16.dp)) { StepText(state, tutorial) }
            Column(Modifier.weight(1f)) { TutorialTask(state, tutorial, onEvent) }
        }
    } else {
        Column(scrolled, Arrangement.spacedBy(16.dp)) {
            StepText(state, tutorial)
            TutorialTask(state, tutorial, onEvent)
        }
    }
}

@Composable
private fun StepText(state: LearningState, tutorial: TutorialState) {
    val text = tutorial.current.text(state.language, state.isInBlocks)
    Text(
        text.title,
        Modifier.testTag(LearningTags.STEP_TITLE).heading(),
        // A long word of a larger title would be broken on a phone.
        TextStyle(
            fontSize = if (LocalDensity.current.fontScale > LARGE) TextSizes.LEAD else TextSizes.KEY,
            lineHeight = LineHeights.HEADING,
        ).strong,
        color = LocalRobotranColours.current.onPane,
    )
    for (paragraph in text.paragraphs) MarkedText(paragraph)
}

/** From this font scale on, the text itself is as large as a title. */
private const val LARGE = 1.5f

/** From this width on, at default font size, the task is next to the text. */
private val BROAD = 640.dp

/** The max share of the pane for the full set of actions. */
private const val FOOT_SHARE = 0.35f
