package robotran.ui.send

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxHeight
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.DpSize
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendStep

/** What [step] shows: its picture and its words. */
@Composable
internal fun SendStepView(step: SendStep, onEvent: (SendEvent) -> Unit, modifier: Modifier = Modifier) {
    val picture = pictureOf(step)
    PictureAndWords(picture.draw, step::class to picture, modifier) { StepWords(step, onEvent) }
}

/**
 * A picture above words, or beside them if the sheet is low.
 *
 * @param step each one begins at its top.
 */
@Composable
internal fun PictureAndWords(
    draw: DrawScope.(RobotranColours) -> Unit,
    step: Any,
    modifier: Modifier,
    words: @Composable () -> Unit,
) {
    val colours = LocalRobotranColours.current
    BoxWithConstraints(modifier) {
        val isLow = maxHeight < LOW && maxWidth >= MIN_BESIDE
        Row(Modifier.fillMaxSize(), Arrangement.spacedBy(20.dp)) {
            if (isLow) StepPicture(draw, Modifier.size(LOW_PICTURE))
            key(step) {
                val scroll = rememberScrollState()
                Column(
                    Modifier
                        .weight(1f)
                        .fillMaxHeight()
                        .testTag(SendTags.SEND_WORDS)
                        .scrollHint(scroll, arrow = colours.quiet)
                        .verticalScroll(scroll),
                    Arrangement.spacedBy(12.dp),
                ) {
                    if (!isLow) StepPicture(draw, Modifier.fillMaxWidth().height(PICTURE_HEIGHT))
                    words()
                }
            }
        }
    }
}

@Composable
private fun StepWords(step: SendStep, onEvent: (SendEvent) -> Unit) {
    Explanation(sentenceOf(step), Modifier.testTag(SendTags.SEND_STEP), bad = step is SendStep.Failed)
    adviceOf(step)?.let { Explanation(it) }
    when (step) {
        is SendStep.ChoosingTower -> TowerChoice(step, onEvent)
        is SendStep.ChoosingSlot -> SlotChoice(step, onEvent)
        is SendStep.Sending -> TransferView(step.progress)
        is SendStep.ReadingDatalog -> TransferView(step.progress, SendTexts::datalogEntry)
        is SendStep.Datalog -> DatalogView(step.entries)
        is SendStep.Watching -> MessageLog(step.messages)
        else -> Unit
    }
}

private val LOW = 230.dp
private val MIN_BESIDE = 400.dp
private val LOW_PICTURE = DpSize(160.dp, 80.dp)
private val PICTURE_HEIGHT = 130.dp
