package robotran.ui.handins

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.SchoolTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInsKind
import robotran.workshop.state.HandInsMessage
import robotran.workshop.state.HandInsState

/**
 * What the hand-ins are graded with, and what can be done with all of them.
 *
 * @param hasActions false where these stay above the table.
 */
@Composable
internal fun HandInsHead(state: HandInsState, hasActions: Boolean, onEvent: (HandInsEvent) -> Unit) =
    Column(Modifier.fillMaxWidth(), Arrangement.spacedBy(Space.SMALL)) {
        when (state.kind) {
            HandInsKind.WITH_CHECKS -> Unit
            HandInsKind.WITHOUT_CHECKS -> HelpText(SchoolTexts.handInsNoChecks(spoken))
            HandInsKind.WORLD -> HelpText(SchoolTexts.handInsWorld(spoken))
        }
        if (hasActions) HandInsActions(state, onEvent)
        Text(
            SchoolTexts.handInsLocal(spoken),
            style = TextStyles.smallLines,
            color = LocalRobotranColours.current.quiet,
        )
    }

/** What can be done with all hand-ins. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun HandInsActions(state: HandInsState, onEvent: (HandInsEvent) -> Unit, modifier: Modifier = Modifier) =
    FlowRow(
        modifier,
        horizontalArrangement = Arrangement.spacedBy(Space.SMALL),
        verticalArrangement = Arrangement.spacedBy(Space.SMALL),
    ) {
        Button(SchoolTexts.handInsChoose(spoken), HandInTags.HAND_INS_CHOOSE) {
            onEvent(HandInsEvent.FilesRequested)
        }
        Button(SchoolTexts.handInsPaste(spoken), HandInTags.HAND_INS_PASTE, ButtonKind.SECOND) {
            onEvent(HandInsEvent.PastingRequested)
        }
        for (kind in state.scanners) ScanButton(kind, onEvent)
        if (state.rows.isEmpty()) return@FlowRow
        Button(SchoolTexts.handInsCsv(spoken), HandInTags.HAND_INS_CSV, ButtonKind.SECOND) {
            onEvent(HandInsEvent.CsvRequested)
        }
        Button(SchoolTexts.handInsHtml(spoken), HandInTags.HAND_INS_HTML, ButtonKind.SECOND) {
            onEvent(HandInsEvent.PageRequested)
        }
        Button(SchoolTexts.handInsFeedback(spoken), HandInTags.HAND_INS_FEEDBACK, ButtonKind.SECOND) {
            onEvent(HandInsEvent.FeedbackRequested)
        }
        Button(SchoolTexts.handInsRemove(spoken), HandInTags.HAND_INS_REMOVE, ButtonKind.QUIET) {
            onEvent(HandInsEvent.RemovalRequested)
        }
    }

@Composable
private fun HelpText(label: String) = Text(
    label,
    Modifier
        .fillMaxWidth()
        .background(LocalRobotranColours.current.invite, Shapes.MEDIUM)
        .padding(Space.MEDIUM)
        .testTag(HandInTags.HAND_INS_REMARK),
    TextStyles.label,
    color = LocalRobotranColours.current.onPane,
)

/** What came of the last action, until it is dismissed. Screen readers announce it. */
@Composable
internal fun HandInsMessageText(message: HandInsMessage, onEvent: (HandInsEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Row(
        Modifier
            .fillMaxWidth()
            .padding(Space.SMALL)
            .background(if (message.isError) colours.errorPane else colours.goodPane, Shapes.MEDIUM)
            .padding(start = Space.MEDIUM),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text(
            wordsFor(message),
            Modifier.weight(1f).padding(vertical = Space.SMALL).testTag(HandInTags.HAND_INS_TOLD).announced(),
            TextStyles.label,
            color = if (message.isError) colours.error else colours.onPane,
        )
        if (message is HandInsMessage.Removed) {
            Button(SchoolTexts.handInsUndo(spoken), HandInTags.HAND_INS_UNDO, ButtonKind.QUIET) {
                onEvent(HandInsEvent.RemovalUndone)
            }
        }
        IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), HandInTags.HAND_INS_TOLD_CLOSE) {
            onEvent(HandInsEvent.MessageDismissed)
        }
    }
}
