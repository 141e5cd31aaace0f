package robotran.ui.brick

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.brick.state.BrickState
import robotran.brick.state.RunState
import robotran.ui.run.tags.RunTags
import robotran.ui.texts.BrickLabels
import robotran.ui.texts.CommonTexts
import robotran.uikit.*

/**
 * A message that the display cannot show, and the button that helps; null if there is none.
 *
 * @param isSolved whether the task is solved: then nobody has to know why the motors of a program that has ended stop.
 */
@Composable
fun brickHintWords(state: BrickState, isSolved: Boolean = false): String? = state.explanation.takeUnless {
    isSolved && state.run is RunState.Ended
} ?: if (state.poweredOn) null else BrickLabels.of(state.kind).off(spoken)

/**
 * Shows [brickHintWords] and the calls of an exception, with [action] and a close button if [onClose] is set; empty
 * without a message.
 */
@Composable
fun BrickHint(
    state: BrickState,
    modifier: Modifier = Modifier,
    isSolved: Boolean = false,
    onClose: (() -> Unit)? = null,
    action: @Composable () -> Unit = {},
) {
    val words = brickHintWords(state, isSolved) ?: return
    Surface(modifier.fillMaxWidth()) {
        Row {
            Column(Modifier.weight(1f).padding(12.dp)) {
                Text(
                    words,
                    Modifier.testTag(RunTags.BRICK_HINT).announced(),
                    TextStyles.label,
                )
                state.kind.face.BelowHint(state, Modifier.padding(top = 8.dp))
            }
            action()
            if (onClose != null) {
                IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), RunTags.BRICK_HINT_CLOSE, onClick = onClose)
            }
        }
    }
}
