package robotran.ui.learning

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.SubcomposeLayout
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.learning.Lessons
import robotran.ui.school.tags.LearningTags
import robotran.ui.school.texts.LearningTexts
import robotran.uikit.*
import robotran.workshop.event.LearningEvent
import robotran.workshop.event.RunEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.LearningPage
import robotran.workshop.state.TutorialState

/**
 * All actions on a step, below its text: try or run it, restart it, leave the tutorial, continue. If they would be
 * higher than [max], rare actions move to a menu.
 *
 * @param isBroad whether there may be room for all in one row.
 */
@Composable
internal fun TutorialFoot(
    tutorial: TutorialState,
    done: Boolean,
    isBroad: Boolean,
    max: Dp,
    onEvent: (WorkshopEvent) -> Unit,
) {
    SubcomposeLayout(Modifier.fillMaxWidth()) { constraints ->
        val room = Constraints.fixedWidth(constraints.maxWidth)
        val likeAll = subcompose(FootPart.LIKE_ALL) { LikeAll(tutorial, isBroad) }.single().measure(room)
        val isSlim = likeAll.height > max.roundToPx()
        val foot = subcompose(FootPart.FOOT) {
            Buttons(tutorial, done, isBroad, isSlim, onEvent)
        }.single().measure(room)
        layout(foot.width, foot.height) { foot.place(0, 0) }
    }
}

private enum class FootPart { LIKE_ALL, FOOT }

/** Invisible text with the size of all buttons, for measuring. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun LikeAll(tutorial: TutorialState, isBroad: Boolean) = Box(Modifier.clearAndSetSemantics { }) {
    val own = listOfNotNull(tutorial.first, LearningTexts::beginAgain.takeIf { tutorial.isLoaded }, tutorial.last)
    val way = listOf(LearningTexts::previous, tutorial.onward)
    Column(Modifier.padding(8.dp), Arrangement.spacedBy(8.dp)) {
        for (row in if (isBroad) listOf(own + way) else listOf(own, way)) {
            FlowRow(
                horizontalArrangement = Arrangement.spacedBy(8.dp),
                verticalArrangement = Arrangement.spacedBy(8.dp),
            ) {
                for (words in row) ButtonSize(words(spoken))
            }
        }
    }
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Buttons(
    tutorial: TutorialState,
    done: Boolean,
    isBroad: Boolean,
    isSlim: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
) {
    if (isBroad || isSlim) {
        FlowRow(Modifier.fillMaxWidth().padding(8.dp), Arrangement.SpaceBetween, Arrangement.spacedBy(8.dp)) {
            Previous(tutorial, onEvent)
            First(tutorial, onEvent)
            if (isSlim) StepMenu(tutorial, onEvent) else Others(tutorial, onEvent)
            Next(tutorial, done, onEvent)
        }
    } else {
        Column(Modifier.padding(8.dp), Arrangement.spacedBy(8.dp)) {
            FlowRow(
                horizontalArrangement = Arrangement.spacedBy(8.dp),
                verticalArrangement = Arrangement.spacedBy(8.dp),
            ) {
                First(tutorial, onEvent)
                Others(tutorial, onEvent)
            }
            FlowRow(Modifier.fillMaxWidth(), Arrangement.SpaceBetween, Arrangement.spacedBy(8.dp)) {
                Previous(tutorial, onEvent)
                Next(tutorial, done, onEvent)
            }
        }
    }
}

/** Run, once the step's program is loaded. */
@Composable
private fun First(tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) {
    val words = tutorial.first(spoken)
    if (tutorial.isLoaded) {
        Button(words, LearningTags.RUN_STEP, ButtonKind.SECOND) { onEvent(RunEvent.RunPressed) }
    } else {
        Button(words, LearningTags.TRY_STEP, help = LearningTexts.tryStepHelp(spoken)) {
            onEvent(LearningEvent.StepTried)
        }
    }
}

/** Restart and leave. */
@Composable
private fun Others(tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) {
    if (tutorial.isLoaded) {
        Button(LearningTexts.beginAgain(spoken), LearningTags.BEGIN_AGAIN, ButtonKind.QUIET) {
            onEvent(LearningEvent.StepRestarted)
        }
    }
    Button(tutorial.last(spoken), LearningTags.LEAVE_TUTORIAL, ButtonKind.QUIET) {
        onEvent(LearningEvent.TutorialClosed)
    }
}

/** The same as a menu, if there is too little room. */
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
            MenuItem(tutorial.last(spoken), LearningTags.LEAVE_TUTORIAL) { choose(LearningEvent.TutorialClosed) }
        }
    }
}

@Composable
private fun Previous(tutorial: TutorialState, onEvent: (WorkshopEvent) -> Unit) = Button(
    LearningTexts.previous(spoken),
    LearningTags.PREVIOUS_STEP,
    ButtonKind.QUIET,
    enabled = tutorial.step > 0,
) { onEvent(LearningEvent.StepChosen(tutorial.step - 1)) }

/** After the last step, opens the worlds. */
@Composable
private fun Next(tutorial: TutorialState, done: Boolean, onEvent: (WorkshopEvent) -> Unit) {
    val words = tutorial.onward(spoken)
    val next = {
        onEvent(
            if (tutorial.isAtEnd) {
                LearningEvent.PageRequested(LearningPage.WORLDS)
            } else {
                LearningEvent.StepChosen(tutorial.step + 1)
            },
        )
    }
    if (done) {
        Button(words, LearningTags.NEXT_STEP, onClick = next)
    } else {
        Button(
            words,
            LearningTags.NEXT_STEP,
            ButtonKind.SECOND,
            onClick = next,
        )
    }
}

private val TutorialState.isAtEnd: Boolean get() = step == Lessons.all.lastIndex

private val TutorialState.first: Label
    get() = if (isLoaded) LearningTexts::runStep else LearningTexts::tryStep

private val TutorialState.last: Label
    get() = if (isLoaded) LearningTexts::leave else LearningTexts::close

private val TutorialState.onward: Label
    get() = if (isAtEnd) LearningTexts::tryWorlds else LearningTexts::next
