package robotran.ui.send.hub

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.ui.send.Announcer
import robotran.ui.send.PERCENT
import robotran.ui.send.PictureAndWords
import robotran.ui.send.QUARTERS
import robotran.uikit.*
import robotran.workshop.event.HubSendEvent
import robotran.workshop.state.HubSendState
import robotran.workshop.state.HubSendStep

/** The sheet that sends a program to a real hub. A touch outside does not close it. */
@Composable
fun HubSendDialog(state: HubSendState, onEvent: (HubSendEvent) -> Unit) = StepsDialog(
    { onEvent(HubSendEvent.Cancelled) },
    closesByTouchOutside = false,
) { HubSendCard(state, onEvent, it) }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
fun HubSendCard(state: HubSendState, onEvent: (HubSendEvent) -> Unit, modifier: Modifier = Modifier) =
    StepsCard(SendTexts.title(spoken, state.program), SendTags.SEND_SHEET, SIZE, modifier, maxTitleLines = 1) {
        val picture = hubPictureOf(state)
        PictureAndWords(picture.draw, state.step::class to picture, Modifier.weight(1f).fillMaxWidth()) {
            HubStepWords(state, onEvent)
        }
        HubSendButtons(state, onEvent, Modifier.fillMaxWidth())
        Announcer(saidOf(state))
    }

/** Each new step, and a quarter of a transfer at a time. */
@Composable
private fun saidOf(state: HubSendState): String {
    val progress = (state.step as? HubSendStep.Sending)?.progress
    val quarters = ((partOf(progress)?.share ?: 0f) * QUARTERS).toInt()
    return if (quarters == 0) sentenceOf(state) else SendTexts.saidProgress(spoken, quarters * PERCENT / QUARTERS)
}

/** Enough for the longest step with text of the usual size. */
private val SIZE = DpSize(560.dp, 560.dp)
