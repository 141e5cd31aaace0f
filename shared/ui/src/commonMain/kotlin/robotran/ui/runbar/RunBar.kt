package robotran.ui.runbar

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.clock
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.RunEvent
import robotran.ui.workshop.WorkshopEvent
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorkshopStatus

/** Run, Stop, and what is going on; always in sight. At its end there is room for [more]. */
@Composable
internal fun RunBar(
    state: WorkshopState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
    more: @Composable () -> Unit = {},
) {
    Row(
        modifier
            .fillMaxWidth()
            .background(LocalRobotranColours.current.pane)
            .defaultMinSize(minHeight = 72.dp)
            .padding(horizontal = 16.dp, vertical = 8.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        RunButton(pulsing = state.untouched && state.status == WorkshopStatus.Ready, onClick = { onEvent(RunEvent.RunPressed) })
        StopButton(enabled = state.stoppable, onClick = { onEvent(RunEvent.StopPressed) })
        Status(state, Modifier.weight(1f))
        more()
    }
}

@Composable
private fun Status(state: WorkshopState, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val status = state.status
    val wrong = status is WorkshopStatus.Mistaken || status is WorkshopStatus.Failed
    Column(modifier.padding(start = 4.dp)) {
        Text(
            statusText(status),
            Modifier.testTag("status").semantics { liveRegion = LiveRegionMode.Polite },
            color = if (wrong) colours.mistake else colours.onPane,
            fontSize = 16.sp,
            lineHeight = 20.sp,
            fontWeight = FontWeight.Medium,
            maxLines = 3,
            overflow = TextOverflow.Ellipsis,
        )
        if (!state.untouched) {
            Text(
                stringResource(Res.string.clock, oneDecimal(state.session.milliseconds / MILLISECONDS_PER_SECOND)),
                Modifier.testTag("clock"),
                color = colours.quiet,
                fontSize = 14.sp,
                maxLines = 1,
            )
        }
    }
}

private const val MILLISECONDS_PER_SECOND = 1000.0
