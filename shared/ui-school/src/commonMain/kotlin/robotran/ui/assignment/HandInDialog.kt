package robotran.ui.assignment

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.AssignmentTags
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.HandInStep

/** The sheet with which a pupil hands in. Only its buttons close it, so that no touch outside loses the hand-in. */
@Composable
fun HandInDialog(step: HandInStep, hasShareSheet: Boolean, onEvent: (WorkshopEvent) -> Unit) = StepsDialog(
    { onEvent(AssignmentEvent.HandInClosed) },
    closesByTouchOutside = false,
) { HandInCard(step, hasShareSheet, onEvent, it) }

@Composable
private fun HandInCard(
    step: HandInStep,
    hasShareSheet: Boolean,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier,
) {
    val title = SchoolTexts.handInTitle(spoken)
    DialogCard(title, AssignmentTags.HAND_IN_SHEET, modifier.sized(SIZE)) {
        BoxWithConstraints(Modifier.padding(if (LocalDensity.current.fontScale > LARGE) 12.dp else 20.dp)) {
            val scroll = rememberScrollState()
            val scrolling = Modifier
                .fillMaxWidth()
                .scrollHint(scroll)
                .verticalScroll(scroll)
            // On a phone in landscape all scrolls, so that a code has all the height.
            if (maxHeight < LOW) {
                Column(scrolling, Arrangement.spacedBy(12.dp)) {
                    DialogTitle(title)
                    Step(step, hasShareSheet, this@BoxWithConstraints.maxHeight - TITLE, onEvent)
                    Buttons(step, onEvent)
                }
            } else {
                Column(Modifier.fillMaxSize(), Arrangement.spacedBy(12.dp)) {
                    DialogTitle(title)
                    BoxWithConstraints(Modifier.weight(1f).fillMaxWidth()) {
                        Column(scrolling.fillMaxHeight(), Arrangement.spacedBy(12.dp)) {
                            Step(step, hasShareSheet, this@BoxWithConstraints.maxHeight, onEvent)
                        }
                    }
                    Buttons(step, onEvent)
                }
            }
        }
    }
}

/** @param maxHeight of what is seen at once. */
@Composable
private fun Step(step: HandInStep, hasShareSheet: Boolean, maxHeight: Dp, onEvent: (WorkshopEvent) -> Unit) {
    when (step) {
        is HandInStep.Asking -> AskingView(step, onEvent)
        is HandInStep.Running -> RunningView(step)
        is HandInStep.HasErrors -> ErrorsView(step)
        is HandInStep.Ready -> ReadyView(step, hasShareSheet, maxHeight, onEvent)
    }
}

/** At the left the button that leaves the step, at the right what goes on. */
@Composable
private fun Buttons(step: HandInStep, onEvent: (WorkshopEvent) -> Unit) = ButtonRows(Modifier.fillMaxWidth()) {
    val close = { onEvent(AssignmentEvent.HandInClosed) }
    val back = { onEvent(AssignmentEvent.HandInBackRequested) }
    when (step) {
        is HandInStep.Asking -> {
            Button(
                SchoolTexts.handInCancel(spoken),
                AssignmentTags.HAND_IN_CANCEL,
                ButtonKind.DIALOG_OTHER,
                onClick = close,
            )
            Button(
                SchoolTexts.handInGoOn(spoken),
                AssignmentTags.HAND_IN_GO_ON,
                ButtonKind.DIALOG_MAIN,
                enabled = step.canGoOn,
            ) {
                onEvent(AssignmentEvent.HandInMade())
            }
        }

        is HandInStep.Running -> Button(
            SchoolTexts.handInCancel(spoken),
            AssignmentTags.HAND_IN_STOP,
            ButtonKind.DIALOG_OTHER,
            onClick = back,
        )

        is HandInStep.HasErrors -> {
            Button(SchoolTexts.handInBack(spoken), AssignmentTags.HAND_IN_BACK, ButtonKind.DIALOG_OTHER, onClick = back)
            Button(SchoolTexts.handInMistakesAnyway(spoken), AssignmentTags.HAND_IN_ANYWAY, ButtonKind.DIALOG_MAIN) {
                onEvent(AssignmentEvent.HandInMade(withErrors = true))
            }
        }

        is HandInStep.Ready -> {
            Button(SchoolTexts.handInBack(spoken), AssignmentTags.HAND_IN_BACK, ButtonKind.DIALOG_OTHER, onClick = back)
            Button(
                SchoolTexts.handInClose(spoken),
                AssignmentTags.HAND_IN_CLOSE,
                ButtonKind.DIALOG_MAIN,
                onClick = close,
            )
        }
    }
}

private val SIZE = DpSize(600.dp, 720.dp)

/** Below this height, title and buttons would leave too little room for a code. */
private val LOW = 400.dp

/** The height of the title at default font size. */
private val TITLE = 44.dp

/** From this font scale on, the edges are narrower. */
private const val LARGE = 1.3f
