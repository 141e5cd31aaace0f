package robotran.ui.documents

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
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
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.documents_my_work
import robotran.ui.resources.documents_save_as
import robotran.ui.resources.documents_trouble_failed
import robotran.ui.resources.documents_trouble_full
import robotran.ui.resources.documents_trouble_long
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.workshop.DocumentEvent
import robotran.ui.workshop.DocumentState
import robotran.ui.workshop.KeepingTrouble

/** Says for as long as it lasts that the work is not being kept, and what can be done; nothing while all is well. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun KeepingBanner(state: DocumentState, onEvent: (DocumentEvent) -> Unit, modifier: Modifier = Modifier) {
    val trouble = state.trouble ?: return
    val colours = LocalRobotranColours.current
    FlowRow(
        modifier.fillMaxWidth().background(colours.mistakePane).padding(horizontal = 16.dp, vertical = 4.dp).testTag("keeping-trouble"),
        Arrangement.spacedBy(8.dp),
        Arrangement.Center,
    ) {
        Text(
            "⚠ ${wordsFor(trouble)}",
            Modifier.align(Alignment.CenterVertically).padding(vertical = 8.dp).semantics { liveRegion = LiveRegionMode.Assertive },
            color = colours.onPane,
            fontSize = 16.sp,
            lineHeight = 22.sp,
        )
        if (trouble != KeepingTrouble.TooLong) {
            OtherButton(stringResource(Res.string.documents_save_as), "trouble-save-as") { onEvent(DocumentEvent.SaveAsWanted) }
        }
        if (trouble == KeepingTrouble.Full) {
            OtherButton(stringResource(Res.string.documents_my_work), "trouble-my-work") { onEvent(DocumentEvent.WorksWanted) }
        }
    }
}

@Composable
private fun wordsFor(trouble: KeepingTrouble): String = when (trouble) {
    KeepingTrouble.Full -> stringResource(Res.string.documents_trouble_full)
    KeepingTrouble.TooLong -> stringResource(Res.string.documents_trouble_long)
    is KeepingTrouble.Failed -> stringResource(Res.string.documents_trouble_failed, trouble.reason)
}
