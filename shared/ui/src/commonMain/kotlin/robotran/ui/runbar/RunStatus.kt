package robotran.ui.runbar

import androidx.compose.foundation.layout.Column
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.clock
import robotran.ui.resources.run_clock_of
import robotran.ui.resources.run_status_past
import robotran.ui.resources.run_status_seeking
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.Pace
import robotran.ui.workshop.WorkshopState
import robotran.ui.workshop.WorkshopStatus

/** What is going on, in a sentence, and when. */
@Composable
internal fun RunStatus(state: WorkshopState, modifier: Modifier = Modifier) {
    val colours = LocalRobotranColours.current
    val status = state.status
    val elsewhere = wordsElsewhere(state, status)
    val wrong = elsewhere == null && (status is WorkshopStatus.Mistaken || status is WorkshopStatus.Failed)
    Column(modifier) {
        Text(
            elsewhere ?: statusText(status),
            // While somebody scrubs, the timeline itself says where it is.
            Modifier.testTag("status").semantics { if (state.run.pace != Pace.SEEKING) liveRegion = LiveRegionMode.Polite },
            color = if (wrong) colours.mistake else colours.onPane,
            fontSize = 16.sp,
            lineHeight = 20.sp,
            fontWeight = FontWeight.Medium,
            maxLines = 3,
            overflow = TextOverflow.Ellipsis,
        )
        if (!state.untouched) {
            val now = stringResource(Res.string.clock, seconds(state.run.time))
            Text(
                if (state.run.inPast) stringResource(Res.string.run_clock_of, now, seconds(state.run.length)) else now,
                Modifier.testTag("clock"),
                color = colours.quiet,
                fontSize = 14.sp,
                maxLines = 1,
            )
        }
    }
}

/** What is going on where somebody looks at another time of the run; null if nobody does. */
@Composable
private fun wordsElsewhere(state: WorkshopState, status: WorkshopStatus): String? {
    val run = state.run
    val mark = if (run.pace == Pace.PAUSED) markAt(run.marks, run.time) else null
    return when {
        run.pace == Pace.SEEKING -> stringResource(Res.string.run_status_seeking, seconds(run.time))
        status is WorkshopStatus.Paused && mark != null -> markText(mark)
        run.pace == Pace.PAUSED && run.inPast && !state.running -> mark?.let { markText(it) } ?: stringResource(Res.string.run_status_past)
        else -> null
    }
}
