package robotran.ui.common

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.verticalScroll
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.liveRegion
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import robotran.ui.common.tags.CommonTags
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.AutosaveError
import robotran.workshop.state.DocumentState

/**
 * A banner that says that autosave fails and what to do; empty otherwise. It covers the bottom of the content, which
 * does not move, until it is closed. The project menu then shows a sign and reopens it.
 */
@OptIn(ExperimentalLayoutApi::class)
@Composable
fun AutosaveBanner(state: DocumentState, onEvent: (DocumentEvent) -> Unit, modifier: Modifier = Modifier) {
    val error = state.error?.takeIf { state.warningShown } ?: return
    val colours = LocalRobotranColours.current
    val scroll = rememberScrollState()
    Row(
        modifier
            .widthIn(max = MAX_WIDTH)
            .fillMaxWidth()
            .background(colours.errorPane, SHAPE)
            .border(1.dp, colours.line, SHAPE)
            // Blocks touches on the content below.
            .pointerInput(Unit) { }
            .testTag(CommonTags.KEEPING_TROUBLE),
    ) {
        FlowRow(
            Modifier
                .weight(1f)
                .scrollHint(scroll, ground = colours.errorPane)
                .verticalScroll(scroll)
                .padding(start = 16.dp, top = 4.dp, bottom = 4.dp),
            Arrangement.spacedBy(8.dp),
            Arrangement.Center,
        ) {
            Text(
                "⚠ ${wordsFor(error)}",
                Modifier.align(Alignment.CenterVertically).padding(vertical = 8.dp).semantics {
                    liveRegion = LiveRegionMode.Assertive
                },
                TextStyles.label,
            )
            if (error != AutosaveError.TooLong) {
                Button(CommonTexts.saveAs(spoken), CommonTags.TROUBLE_SAVE_AS, ButtonKind.DIALOG_OTHER) {
                    onEvent(DocumentEvent.SaveAsRequested)
                }
            }
            if (error == AutosaveError.Full) {
                Button(CommonTexts.myWork(spoken), CommonTags.TROUBLE_MY_WORK, ButtonKind.DIALOG_OTHER) {
                    onEvent(DocumentEvent.ProjectListRequested)
                }
            }
        }
        IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), CommonTags.TROUBLE_CLOSE) {
            onEvent(DocumentEvent.WarningShown(false))
        }
    }
}

@Composable
private fun wordsFor(error: AutosaveError): String = when (error) {
    AutosaveError.Full -> CommonTexts.troubleFull(spoken)
    AutosaveError.TooLong -> CommonTexts.troubleLong(spoken)
    AutosaveError.NoAnswer -> CommonTexts.troubleSilent(spoken)
    is AutosaveError.Failed -> CommonTexts.troubleFailed(spoken, error.reason)
}

private val SHAPE = Shapes.MEDIUM
private val MAX_WIDTH = 560.dp
