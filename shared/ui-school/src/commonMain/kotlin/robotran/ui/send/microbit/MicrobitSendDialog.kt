package robotran.ui.send.microbit

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
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.MicrobitSendState
import robotran.workshop.state.MicrobitSendStep

/** The sheet that gets a program onto a real micro:bit. A touch outside does not close it. */
@Composable
fun MicrobitSendDialog(state: MicrobitSendState, onEvent: (MicrobitSendEvent) -> Unit) = StepsDialog(
    { onEvent(MicrobitSendEvent.Cancelled) },
    closesByTouchOutside = false,
) { MicrobitSendCard(state, onEvent, it) }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
fun MicrobitSendCard(state: MicrobitSendState, onEvent: (MicrobitSendEvent) -> Unit, modifier: Modifier = Modifier) =
    StepsCard(SendTexts.title(spoken, state.program), SendTags.SEND_SHEET, SIZE, modifier, maxTitleLines = 1) {
        val picture = microbitPictureOf(state)
        PictureAndWords(picture.draw, state.step::class to picture, Modifier.weight(1f).fillMaxWidth()) {
            MicrobitStepWords(state, onEvent)
        }
        MicrobitSendButtons(state, onEvent, Modifier.fillMaxWidth())
        Announcer(saidOf(state))
    }

/** Each new step, and a quarter of a transfer at a time. */
@Composable
private fun saidOf(state: MicrobitSendState): String {
    val progress = (state.step as? MicrobitSendStep.Sending)?.progress
    val quarters = ((partOf(progress)?.share ?: 0f) * QUARTERS).toInt()
    return if (quarters == 0) sentenceOf(state) else SendTexts.saidProgress(spoken, quarters * PERCENT / QUARTERS)
}

/** Enough for the longest step with text of the usual size. */
private val SIZE = DpSize(560.dp, 600.dp)
