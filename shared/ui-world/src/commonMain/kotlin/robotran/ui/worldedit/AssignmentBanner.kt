package robotran.ui.worldedit

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.EditOrigin

/** What is edited for an assignment, and the way back to it. */
@OptIn(ExperimentalLayoutApi::class)
@Composable
internal fun AssignmentBanner(origin: EditOrigin, onEvent: (WorkshopEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    val words = origin.variation?.let { WorldEditorTexts.ofVariation(spoken, it, origin.assignment) }
        ?: WorldEditorTexts.ofAssignment(spoken, origin.assignment)
    FlowRow(
        Modifier
            .fillMaxWidth()
            .background(colours.runningLine)
            .testTag(WorldTags.EDIT_OF_ASSIGNMENT)
            .padding(horizontal = 12.dp, vertical = 4.dp),
        Arrangement.spacedBy(12.dp),
        Arrangement.spacedBy(4.dp),
    ) {
        Text(
            words,
            Modifier
                .align(Alignment.CenterVertically)
                .testTag(WorldTags.EDIT_OF_ASSIGNMENT_WORDS)
                .announced(),
            TextStyles.smallLines,
        )
        Button(WorldEditorTexts.toAssignment(spoken), WorldTags.EDIT_TO_ASSIGNMENT, ButtonKind.SECOND) {
            onEvent(WorldEditEvent.EditorClosed)
        }
    }
}
