package robotran.ui.documents

import androidx.compose.foundation.Canvas
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.DropdownMenu
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clip
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.stateDescription
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.ui.platform.FileKind
import robotran.ui.resources.Res
import robotran.ui.resources.documents_drawing
import robotran.ui.resources.documents_kit
import robotran.ui.resources.documents_menu
import robotran.ui.resources.documents_my_work
import robotran.ui.resources.documents_new
import robotran.ui.resources.documents_open
import robotran.ui.resources.documents_open_link
import robotran.ui.resources.documents_picture
import robotran.ui.resources.documents_program_file
import robotran.ui.resources.documents_rename
import robotran.ui.resources.documents_replay
import robotran.ui.resources.documents_save
import robotran.ui.resources.documents_save_as
import robotran.ui.resources.documents_share
import robotran.ui.resources.documents_unsaved
import robotran.ui.resources.documents_untitled
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.Measures
import robotran.ui.theme.focusRing
import robotran.ui.workshop.DocumentEvent
import robotran.ui.workshop.DocumentState

/**
 * The name of the work, which opens the menu with all that can be done with it as a whole. A dot before the name says that not everything is in its
 * file yet.
 */
@Composable
internal fun WorkMenu(
    state: DocumentState,
    onEvent: (DocumentEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    var open by remember { mutableStateOf(false) }
    Box(modifier) {
        WorkName(state) { open = true }
        DropdownMenu(
            expanded = open,
            onDismissRequest = { open = false },
            modifier = Modifier.widthIn(min = 240.dp).testTag("work-menu-items"),
            containerColor = LocalRobotranColours.current.pane,
        ) {
            WorkMenuItems(state, onEvent, { open = false })
        }
    }
}

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
private fun WorkMenuItem(words: StringResource, tag: String, onClick: () -> Unit) {
    DropdownMenuItem(
        text = { Text(stringResource(words), color = LocalRobotranColours.current.onPane, fontSize = 16.sp) },
        onClick = onClick,
        modifier = Modifier.heightIn(min = Measures.TARGET).testTag("work-$tag"),
    )
}

@Composable
private fun WorkName(state: DocumentState, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    val name = state.name.ifEmpty { stringResource(Res.string.documents_untitled) }
    val words = stringResource(Res.string.documents_menu, name)
    val unsaved = stringResource(Res.string.documents_unsaved)
    val isUnsaved = state.fileName != null && !state.saved
    Row(
        Modifier
            .testTag("work-menu")
            .heightIn(min = Measures.TARGET)
            .clip(RoundedCornerShape(12.dp))
            .focusRing()
            .clickable(role = Role.DropdownList, onClick = onClick)
            .semantics(mergeDescendants = true) {
                contentDescription = words
                if (isUnsaved) stateDescription = unsaved
            }
            .padding(horizontal = 12.dp),
        Arrangement.spacedBy(8.dp),
        Alignment.CenterVertically,
    ) {
        if (isUnsaved) Text("●", color = colours.onPane, fontSize = 12.sp)
        Text(
            name,
            Modifier.weight(1f, fill = false),
            color = colours.onPane,
            fontSize = 16.sp,
            fontWeight = FontWeight.Medium,
            maxLines = 1,
            overflow = TextOverflow.Ellipsis,
        )
        Canvas(Modifier.size(10.dp, 6.dp)) {
            val width = 2.dp.toPx()
            val tip = Offset(size.width / 2, size.height)
            drawLine(colours.quiet, Offset.Zero, tip, width, StrokeCap.Round)
            drawLine(colours.quiet, Offset(size.width, 0f), tip, width, StrokeCap.Round)
        }
    }
}
