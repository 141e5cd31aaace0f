package robotran.ui.learning

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.learning.Tutorial
import robotran.ui.resources.Res
import robotran.ui.resources.learning_begin_again
import robotran.ui.resources.learning_close
import robotran.ui.resources.learning_leave
import robotran.ui.resources.learning_next
import robotran.ui.resources.learning_previous
import robotran.ui.resources.learning_run_step
import robotran.ui.resources.learning_try_step
import robotran.ui.resources.learning_try_step_help
import robotran.ui.resources.learning_try_worlds
import robotran.ui.resources.learning_tutorial
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.LearningEvent
import robotran.ui.workshop.LearningPage
import robotran.ui.workshop.LearningState
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.TutorialState
import robotran.ui.workshop.WorkshopEvent

/** The step of the tutorial that is shown: what to read, what to try, what to do. Stands beside the program, over it, or in its place. */
@Composable
internal fun TutorialPane(state: LearningState, onEvent: (WorkshopEvent) -> Unit, modifier: Modifier = Modifier) {
    val tutorial = state.tutorial ?: return
    val colours = LocalRobotranColours.current
    val title = stringResource(Res.string.learning_tutorial)
    Column(modifier.background(colours.pane).testTag("tutorial").semantics { paneTitle = title }) {
        TutorialStrip(state, onEvent)
        HorizontalDivider(color = colours.line)
        key(tutorial.step) {
            BoxWithConstraints(Modifier.weight(1f).fillMaxWidth()) {
                val isBroad = maxWidth >= BROAD * LocalDensity.current.fontScale
                val scrolled = Modifier.fillMaxSize().verticalScroll(rememberScrollState()).padding(horizontal = 20.dp, vertical = 16.dp)
                if (isBroad) {
                    Row(scrolled, Arrangement.spacedBy(24.dp)) {
                        Column(Modifier.weight(1f), Arrangement.spacedBy(16.dp)) { StepText(state, tutorial) }
                        Column(Modifier.weight(1f), Arrangement.spacedBy(16.dp)) { StepTask(state, tutorial, onEvent) }
                    }
                } else {
                    Column(scrolled, Arrangement.spacedBy(16.dp)) {
                        StepText(state, tutorial)
                        StepTask(state, tutorial, onEvent)
                    }
                }
            }
        }
        HorizontalDivider(color = colours.line)
        WayOn(tutorial, state.isStepDone, onEvent)
    }
}

@Composable
private fun StepTask(state: LearningState, tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) {
    TutorialTask(state, tutorial, onEvent)
    StepButtons(tutorial, onEvent)
}

@Composable
private fun StepText(state: LearningState, tutorial: TutorialState) {
    val text = tutorial.current.text(state.language)
    Text(
        text.title,
        Modifier.testTag("step-title").semantics { heading() },
        color = LocalRobotranColours.current.onPane,
        fontSize = 24.sp,
        lineHeight = 30.sp,
        fontWeight = FontWeight.SemiBold,
    )
    for (paragraph in text.paragraphs) MarkedText(paragraph)
}

/** Try it, and once that was done: Run, and the ways back. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun StepButtons(tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) {
    FlowRow(horizontalArrangement = Arrangement.spacedBy(8.dp), verticalArrangement = Arrangement.spacedBy(8.dp)) {
        if (tutorial.isOnDesk) {
            SecondButton(stringResource(Res.string.learning_run_step), "run-step", { onEvent(RunEvent.RunPressed) })
            QuietButton(stringResource(Res.string.learning_begin_again), "begin-again", { onEvent(LearningEvent.StepBegunAgain) })
        } else {
            val help = stringResource(Res.string.learning_try_step_help)
            PrimaryButton(stringResource(Res.string.learning_try_step), "try-step", { onEvent(LearningEvent.StepTried) }, help = help)
        }
        val leave = if (tutorial.isOnDesk) Res.string.learning_leave else Res.string.learning_close
        QuietButton(stringResource(leave), "leave-tutorial", { onEvent(LearningEvent.TutorialLeft) })
    }
}

/** To the step before and the next one; after the last one, to the worlds. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun WayOn(tutorial: TutorialState, done: Boolean, onEvent: (WorkshopEvent) -> Unit) {
    FlowRow(Modifier.fillMaxWidth().padding(8.dp), Arrangement.SpaceBetween) {
        QuietButton(
            stringResource(Res.string.learning_previous),
            "previous-step",
            { onEvent(LearningEvent.StepChosen(tutorial.step - 1)) },
            enabled = tutorial.step > 0,
        )
        val isLast = tutorial.step == Tutorial.steps.lastIndex
        val text = stringResource(if (isLast) Res.string.learning_try_worlds else Res.string.learning_next)
        val next = { onEvent(if (isLast) LearningEvent.PageWanted(LearningPage.WORLDS) else LearningEvent.StepChosen(tutorial.step + 1)) }
        if (done) PrimaryButton(text, "next-step", next) else SecondButton(text, "next-step", next)
    }
}

/** From this width on, at usual text size, the task stands beside the text. */
private val BROAD = 640.dp
