package robotran.ui.send

import androidx.compose.foundation.BorderStroke
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.paneTitle
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.window.DialogProperties
import robotran.ui.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.event.SendEvent
import robotran.workshop.state.SendState

/**
 * The sheet that sends a program to a real robot. A touch outside does not close it, since that would end a transfer of
 * minutes.
 */
@Composable
internal fun SendDialog(state: SendState, onEvent: (SendEvent) -> Unit) = AppDialog(
    { onEvent(SendEvent.Cancelled) },
    // The default width would be too narrow for a phone on its side.
    DialogProperties(dismissOnClickOutside = false, usePlatformDefaultWidth = false),
) { SendCard(state, onEvent, Modifier.padding(MARGIN)) }

/** The sheet without its window. It has one size for all steps, so its buttons stay where they are. */
@Composable
internal fun SendCard(state: SendState, onEvent: (SendEvent) -> Unit, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val title = SendTexts.title(spoken, state.program)
    val scale = LocalDensity.current.fontScale
    Surface(
        modifier
            .size(WIDTH * minOf(scale, MAX_WIDENING), HEIGHT * scale)
            .testTag("send-sheet")
            .semantics { paneTitle = title },
        Shapes.SHEET,
    ) {
        Column(Modifier.padding(20.dp), Arrangement.spacedBy(12.dp)) {
            Text(
                title,
                Modifier.semantics { heading() },
                TextStyles.dialogTitle,
                maxLines = 1,
                overflow = TextOverflow.Ellipsis,
            )
            SendStepView(state.step, onEvent, Modifier.weight(1f).fillMaxWidth())
            SendButtons(state.step, onEvent, Modifier.fillMaxWidth())
            SendAnnouncer(state.step)
        }
    }
}

private val MARGIN = 16.dp
private val WIDTH = 560.dp

/** With large text the sheet becomes wider up to here; beyond, its lines would be too long. */
private const val MAX_WIDENING = 1.4f

/** Enough for the longest step with text of the usual size. */
private val HEIGHT = 560.dp
