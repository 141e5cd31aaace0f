package robotran.ui.send.microbit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.microbitlink.sentences.sentence
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.MicrobitSendTexts
import robotran.ui.send.SmallStepPicture
import robotran.uikit.*
import robotran.workshop.event.MicrobitSendEvent
import robotran.workshop.state.MicrobitSendStep

/** What is left to do with a file that was saved, step by step, and what a number on the board means. */
@Composable
internal fun CopySteps(step: MicrobitSendStep.HexSaved, onEvent: (MicrobitSendEvent) -> Unit) {
    // The first step has the picture above.
    Explanation(MicrobitSendTexts.stepPlugIn(spoken))
    PicturedStep(MicrobitPicture.COPY, MicrobitSendTexts.stepCopy(spoken, step.file))
    PicturedStep(MicrobitPicture.PRESS_A, MicrobitSendTexts.stepStart(spoken))
    Explanation(MicrobitSendTexts.onPhone(spoken))
    PicturedStep(MicrobitPicture.SAD, MicrobitSendTexts.numberLabel(spoken))
    CompactField(
        step.number.text,
        FieldWords(MicrobitSendTexts.numberLabel(spoken), SendTags.SEND_NUMBER, hint = EXAMPLE),
        Modifier.size(FIELD),
        CompactFieldKind.NUMBER,
    ) { onEvent(MicrobitSendEvent.NumberEntered(it)) }
    step.number.kind?.let { kind ->
        PicturedStep(pictureOf(kind), kind.sentence(spoken), Modifier.testTag(SendTags.SEND_MEANING))
    }
}

@Composable
private fun PicturedStep(picture: MicrobitPicture, words: String, modifier: Modifier = Modifier) =
    Row(Modifier.fillMaxWidth(), Arrangement.spacedBy(12.dp), Alignment.CenterVertically) {
        SmallStepPicture(picture.draw, Modifier.size(PICTURE))
        Explanation(words, modifier.weight(1f))
    }

private const val EXAMPLE = "504"
private val FIELD = DpSize(96.dp, 48.dp)
private val PICTURE = DpSize(112.dp, 56.dp)
