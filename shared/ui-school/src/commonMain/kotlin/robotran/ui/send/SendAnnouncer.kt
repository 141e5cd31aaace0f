package robotran.ui.send

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.SendTags
import robotran.ui.school.texts.SendTexts
import robotran.uikit.*
import robotran.workshop.state.SendStep

/** Tells screen readers each new step, and a quarter of a transfer at a time. */
@Composable
internal fun SendAnnouncer(step: SendStep) {
    val quarters = if (step is SendStep.Sending) (partOf(step.progress) * QUARTERS).toInt() else 0
    val said = if (quarters == 0) {
        sentenceOf(step)
    } else {
        SendTexts.saidProgress(spoken, quarters * PERCENT / QUARTERS)
    }
    Announcer(said)
}

/** What screen readers say when [said] changes. */
@Composable
internal fun Announcer(said: String) {
    Box(
        Modifier.size(1.dp).testTag(SendTags.SEND_ANNOUNCER).semantics {
            liveRegion = LiveRegionMode.Polite
            contentDescription = said
        },
    )
}

internal const val QUARTERS = 4
internal const val PERCENT = 100
