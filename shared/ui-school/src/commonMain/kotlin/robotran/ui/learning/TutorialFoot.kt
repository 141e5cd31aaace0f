package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.TutorialState

/**
 * The way through the lessons in one row: back, what is seldom needed in a menu, begin or go to the program, next. What a
 * pupil does next is yellow: begin, or once the task is [done] the next lesson.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun TutorialFoot(
    tutorial: TutorialState,
    done: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    onProgram: (() -> Unit)?,
) = FlowRow(
    Modifier.fillMaxWidth().padding(horizontal = Space.SMALL, vertical = Space.TINY),
    Arrangement.SpaceBetween,
) {
    Row {
        IconButton(
            Icon.BACK,
            LearningTexts.previous(spoken),
            LearningTags.PREVIOUS_STEP,
            enabled = tutorial.step > 0,
        ) { onEvent(LearningEvent.StepChosen(tutorial.step - 1)) }
        StepMenu(tutorial, onEvent)
    }
    Row(horizontalArrangement = Arrangement.spacedBy(Space.SMALL)) {
        if (!tutorial.isLoaded) {
            Button(
                LearningTexts.tryStep(spoken),
                LearningTags.TRY_STEP,
                help = LearningTexts.tryStepHelp(spoken),
            ) { onEvent(LearningEvent.StepTried) }
        } else if (onProgram != null && !done && LocalDensity.current.fontScale <= LARGE_LESSON) {
            Button(LearningTexts.toProgram(spoken), LearningTags.TO_PROGRAM, ButtonKind.SECOND, onClick = onProgram)
        }
        Next(tutorial, done, onEvent)
    }
}

@Composable
private fun StepMenu(tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) {
    var open by remember { mutableStateOf(false) }
    val choose = { event: LearningEvent ->
        open = false
        onEvent(event)
    }
    Box {
        IconButton(Icon.MORE, LearningTexts.stepMore(spoken), LearningTags.STEP_MORE) { open = true }
        AppMenu(open, { open = false }) {
            if (tutorial.isLoaded) {
                MenuItem(LearningTexts.beginAgain(spoken), LearningTags.BEGIN_AGAIN) {
                    choose(LearningEvent.StepRestarted)
                }
            }
            val leave = if (tutorial.isLoaded) LearningTexts::leave else LearningTexts::close
            MenuItem(leave(spoken), LearningTags.LEAVE_TUTORIAL) { choose(LearningEvent.TutorialClosed) }
        }
    }
}

/** After the last step, opens the worlds. */
@Composable
private fun Next(tutorial: TutorialState, done: Boolean, onEvent: (WorkshopEvent) -> Unit) {
    val isAtEnd = tutorial.step == Lessons.all.lastIndex
    val words = if (isAtEnd) LearningTexts::tryWorlds else LearningTexts::next
    val kind = if (done && tutorial.isLoaded) ButtonKind.PRIMARY else ButtonKind.QUIET
    Button(words(spoken), LearningTags.NEXT_STEP, kind) {
        onEvent(
            if (isAtEnd) {
                LearningEvent.PageRequested(LearningPage.WORLDS)
            } else {
                LearningEvent.StepChosen(tutorial.step + 1)
            },
        )
    }
}
