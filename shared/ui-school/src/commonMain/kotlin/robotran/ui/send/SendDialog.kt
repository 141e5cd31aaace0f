package robotran.ui.send

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendState

/**
 * The sheet that sends a program to a real robot. A touch outside does not close it, since that would end a transfer of
 * minutes.
 */
@Composable
fun SendDialog(state: SendState, onEvent: (SendEvent) -> Unit) = StepsDialog(
    { onEvent(SendEvent.Cancelled) },
    closesByTouchOutside = false,
) { SendCard(state, onEvent, it) }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
fun SendCard(state: SendState, onEvent: (SendEvent) -> Unit, modifier: Modifier = Modifier) =
    StepsCard(SendTexts.title(spoken, state.program), SendTags.SEND_SHEET, SIZE, modifier, maxTitleLines = 1) {
        SendStepView(state.step, onEvent, Modifier.weight(1f).fillMaxWidth())
        SendButtons(state.step, onEvent, Modifier.fillMaxWidth())
        SendAnnouncer(state.step)
    }

/** Enough for the longest step with text of the usual size. */
private val SIZE = DpSize(560.dp, 560.dp)
