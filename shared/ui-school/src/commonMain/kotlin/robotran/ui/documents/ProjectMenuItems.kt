package robotran.ui.documents

import androidx.compose.runtime.Composable
import robotran.ui.common.tags.CommonTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.HubTexts
import robotran.ui.texts.NqcTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState

/**
 * What pupils do with their project, as at most nine items of a menu.
 *
 * @param choose closes the menu and sends the event.
 * @param onMore shows [MoreProjectItems] instead.
 */
@Composable
fun ProjectMenuItems(state: DocumentState, choose: (WorkshopEvent) -> Unit, onMore: () -> Unit) {
    if (state.error != null) {
        ProjectMenuItem(DocumentTexts::notKept, DocumentTags.TROUBLE, "⚠ ") { choose(DocumentEvent.WarningShown(true)) }
        HorizontalDivider()
    }
    ProjectMenuItem(CommonTexts::newProject, DocumentTags.NEW) { choose(DocumentEvent.NewRequested) }
    ProjectMenuItem(HubTexts::otherRobot, DocumentTags.NEW_ROBOT) { choose(DocumentEvent.RobotChoiceRequested) }
    ProjectMenuItem(CommonTexts::myWork, DocumentTags.MY_WORK) { choose(DocumentEvent.ProjectListRequested) }
    HorizontalDivider()
    ProjectMenuItem(DocumentTexts::rename, DocumentTags.RENAME) { choose(DocumentEvent.RenameRequested) }
    if (state.fileName != null) {
        ProjectMenuItem(DocumentTexts::save, DocumentTags.SAVE) { choose(DocumentEvent.SaveRequested) }
    }
    ProjectMenuItem(CommonTexts::showWork, DocumentTags.SHOW) { choose(ExportEvent.Requested) }
    ProjectMenuItem(DocumentTexts::share, DocumentTags.SHARE_LINK) { choose(DocumentEvent.LinkRequested) }
    if (state.canSend) ProjectMenuItem(CommonTexts::sendToRobot, CommonTags.SEND_ROBOT) { choose(SendEvent.Requested) }
    HorizontalDivider()
    MenuItem(
        DocumentTexts.more(spoken),
        DocumentTags.menuItem(DocumentTags.MORE),
        trailing = { MoreSign() },
        onClick = onMore,
    )
}

/** What is done with a project now and then: files, and what else can be made of it. */
@Composable
fun MoreProjectItems(state: DocumentState, choose: (WorkshopEvent) -> Unit) {
    ProjectMenuItem(DocumentTexts::open, DocumentTags.OPEN) { choose(DocumentEvent.OpenRequested) }
    ProjectMenuItem(DocumentTexts::openLink, DocumentTags.OPEN_LINK) { choose(DocumentEvent.LinkPastingRequested) }
    HorizontalDivider()
    ProjectMenuItem(CommonTexts::saveAs, DocumentTags.SAVE_AS) { choose(DocumentEvent.SaveAsRequested) }
    ProjectMenuItem(DocumentTexts::programFile, DocumentTags.PROGRAM_FILE) {
        choose(DocumentEvent.ProgramFileRequested)
    }
    val kit = if (state.hasFirmwareImage) NqcTexts::documentsFirmwareImage else CommonTexts::sendingKit
    ProjectMenuItem(kit, DocumentTags.KIT) { choose(DocumentEvent.KitRequested) }
    HorizontalDivider()
    ProjectMenuItem(DocumentTexts::replay, DocumentTags.REPLAY) { choose(DocumentEvent.ReplayRequested) }
}

@Composable
private fun ProjectMenuItem(label: Label, tag: String, sign: String = "", onClick: () -> Unit) {
    MenuItem(sign + label(spoken), DocumentTags.menuItem(tag), onClick = onClick)
}
