package robotran.ui.documents

import androidx.compose.foundation.layout.heightIn
import androidx.compose.material3.DropdownMenuItem
import androidx.compose.material3.HorizontalDivider
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.brick.kind.BrickKind
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.ShowEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState

/** All actions on the project, as items of a menu; [close] closes the menu. */
@Composable
internal fun ProjectMenuItems(state: DocumentState, onEvent: (WorkshopEvent) -> Unit, close: () -> Unit) {
    val choose = { event: WorkshopEvent ->
        close()
        onEvent(event)
    }
    if (state.error != null) {
        ProjectMenuItem(Res.string.documents_not_kept, "trouble", "⚠ ") { choose(DocumentEvent.WarningShown(true)) }
        HorizontalDivider(color = LocalRobotranColours.current.line)
    }
    ProjectMenuItem(Res.string.documents_new, "new") { choose(DocumentEvent.NewRequested) }
    ProjectMenuItem(Res.string.documents_new_nxt, "new-nxt") { choose(DocumentEvent.NewWithBrick(BrickKind.NXT)) }
    ProjectMenuItem(Res.string.documents_my_work, "my-work") { choose(DocumentEvent.ProjectListRequested) }
    ProjectMenuItem(Res.string.documents_open, "open") { choose(DocumentEvent.OpenRequested) }
    ProjectMenuItem(Res.string.documents_open_link, "open-link") { choose(DocumentEvent.LinkPastingRequested) }
    HorizontalDivider(color = LocalRobotranColours.current.line)
    ProjectMenuItem(Res.string.documents_rename, "rename") { choose(DocumentEvent.RenameRequested) }
    if (state.fileName != null) {
        ProjectMenuItem(Res.string.documents_save, "save") { choose(DocumentEvent.SaveRequested) }
    }
    ProjectMenuItem(Res.string.documents_save_as, "save-as") { choose(DocumentEvent.SaveAsRequested) }
    ProjectMenuItem(Res.string.documents_share, "share-link") { choose(DocumentEvent.LinkRequested) }
    HorizontalDivider(color = LocalRobotranColours.current.line)
    if (state.canSend) ProjectMenuItem(Res.string.send_robot, "send-robot") { choose(SendEvent.Requested) }
    ProjectMenuItem(Res.string.show_title, "show") { choose(ShowEvent.Requested) }
    ProjectMenuItem(Res.string.make_title, "make-assignment") { choose(AssignmentEvent.MakingRequested) }
    ProjectMenuItem(Res.string.documents_replay, "replay") { choose(DocumentEvent.ReplayRequested) }
    ProjectMenuItem(Res.string.documents_program_file, "program-file") { choose(DocumentEvent.ProgramFileRequested) }
    val kit = if (state.hasFirmwareImage) Res.string.documents_firmware_image else Res.string.documents_kit
    ProjectMenuItem(kit, "kit") { choose(DocumentEvent.KitRequested) }
    if (state.hasGoals) {
        HorizontalDivider(color = LocalRobotranColours.current.line)
        ProjectMenuItem(Res.string.hand_ins_menu, "hand-ins") { choose(HandInsEvent.Requested) }
    }
}

@Composable
private fun ProjectMenuItem(words: StringResource, tag: String, sign: String = "", onClick: () -> Unit) {
    DropdownMenuItem(
        text = {
            Text(sign + stringResource(words), color = LocalRobotranColours.current.onPane, fontSize = TextSizes.BODY)
        },
        onClick = onClick,
        modifier = Modifier.heightIn(min = Dimensions.TARGET).testTag("work-$tag"),
    )
}
