package robotran.ui.program

import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.dp
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.ProgramEvent

/**
 * A message that the program or class [name] was closed, with a button that restores it if there is [room]. It covers
 * the bottom of the program, which does not move, until it is closed. The plus menu can restore the program later.
 */
@Composable
internal fun ClosedProgram(name: String, room: Boolean, onEvent: (ProgramEvent) -> Unit) {
    val colours = LocalRobotranColours.current
    Surface(Modifier.fillMaxWidth().padding(8.dp), color = colours.desk) {
        Row(
            Modifier.defaultMinSize(
                minHeight = Dimensions.TARGET,
            ).padding(start = 16.dp).testTag(ProgramTags.CLOSED_PROGRAM),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Text(
                EditorTexts.programClosed(spoken, name),
                Modifier.weight(1f).announced(),
                TextStyles.body,
            )
            if (room) {
                Button(
                    EditorTexts.programReopen(spoken),
                    ProgramTags.REOPEN_PROGRAM,
                    ButtonKind.LINK,
                ) { onEvent(ProgramEvent.ProgramReopened) }
            }
            IconButton(Icon.CLOSE, CommonTexts.noticeClose(spoken), ProgramTags.CLOSED_PROGRAM_CLOSE) {
                onEvent(ProgramEvent.ClosedMessageDismissed)
            }
        }
    }
}
