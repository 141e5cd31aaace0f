package robotran.ui.documents

import androidx.compose.foundation.layout.heightIn
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.Res
import robotran.ui.resources.documents_drawing
import robotran.ui.resources.documents_kit
import robotran.ui.resources.documents_my_work
import robotran.ui.resources.documents_new
import robotran.ui.resources.documents_not_kept
import robotran.ui.resources.documents_open
import robotran.ui.resources.documents_open_link
import robotran.ui.resources.documents_picture
import robotran.ui.resources.documents_program_file
import robotran.ui.resources.documents_rename
import robotran.ui.resources.documents_replay
import robotran.ui.resources.documents_save
import robotran.ui.resources.documents_save_as
import robotran.ui.resources.documents_share
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.workshop.event.DocumentEvent
import robotran.workshop.platform.FileKind
import robotran.workshop.state.DocumentState

/** All that can be done with the work as a whole, to be put into a menu; [close] closes that. */
@Composable
internal fun WorkMenuItems(
    state: DocumentState,
    onEvent: (DocumentEvent) -> Unit,
    close: () -> Unit,
) {
    val choose = { event: DocumentEvent ->
        close()
        onEvent(event)
    }
    if (state.trouble != null) {
        WorkMenuItem(Res.string.documents_not_kept, "trouble", "⚠ ") { choose(DocumentEvent.WarningShown(true)) }
        HorizontalDivider(color = LocalRobotranColours.current.line)
    }
    WorkMenuItem(Res.string.documents_new, "new") { choose(DocumentEvent.NewWanted) }
    WorkMenuItem(Res.string.documents_my_work, "my-work") { choose(DocumentEvent.WorksWanted) }
    WorkMenuItem(Res.string.documents_open, "open") { choose(DocumentEvent.OpenWanted) }
    WorkMenuItem(Res.string.documents_open_link, "open-link") { choose(DocumentEvent.LinkPastingWanted) }
    HorizontalDivider(color = LocalRobotranColours.current.line)
    WorkMenuItem(Res.string.documents_rename, "rename") { choose(DocumentEvent.RenameWanted) }
    if (state.fileName != null) WorkMenuItem(Res.string.documents_save, "save") { choose(DocumentEvent.SaveWanted) }
    WorkMenuItem(Res.string.documents_save_as, "save-as") { choose(DocumentEvent.SaveAsWanted) }
    WorkMenuItem(Res.string.documents_share, "share-link") { choose(DocumentEvent.LinkWanted) }
    HorizontalDivider(color = LocalRobotranColours.current.line)
    WorkMenuItem(Res.string.documents_picture, "picture") { choose(DocumentEvent.PictureWanted(FileKind.PNG)) }
    WorkMenuItem(Res.string.documents_drawing, "drawing") { choose(DocumentEvent.PictureWanted(FileKind.SVG)) }
    WorkMenuItem(Res.string.documents_replay, "replay") { choose(DocumentEvent.ReplayWanted) }
    WorkMenuItem(Res.string.documents_program_file, "program-file") { choose(DocumentEvent.ProgramFileWanted) }
    WorkMenuItem(Res.string.documents_kit, "kit") { choose(DocumentEvent.KitWanted) }
}

@Composable
private fun WorkMenuItem(words: StringResource, tag: String, sign: String = "", onClick: () -> Unit) {
    DropdownMenuItem(
        text = { Text(sign + stringResource(words), color = LocalRobotranColours.current.onPane, fontSize = 16.sp) },
        onClick = onClick,
        modifier = Modifier.heightIn(min = Measures.TARGET).testTag("work-$tag"),
    )
}
