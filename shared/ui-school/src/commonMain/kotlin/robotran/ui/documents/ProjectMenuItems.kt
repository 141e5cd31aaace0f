package robotran.ui.documents

import androidx.compose.runtime.Composable
import robotran.ui.common.tags.CommonTags
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.ui.texts.BrickLabels
import robotran.ui.texts.CommonTexts
import robotran.ui.texts.NqcTexts
import robotran.ui.texts.OTHER_BRICKS
import robotran.uikit.*
import robotran.workshop.event.AssignmentEvent
import robotran.workshop.event.DocumentEvent
import robotran.workshop.event.ExportEvent
import robotran.workshop.event.HandInsEvent
import robotran.workshop.event.SendEvent
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState

/** All actions on the project, as items of a menu; [close] closes the menu. */
@Composable
fun ProjectMenuItems(state: DocumentState, onEvent: (WorkshopEvent) -> Unit, close: () -> Unit) {
    val choose = { event: WorkshopEvent ->
        close()
        onEvent(event)
    }
    if (state.error != null) {
        ProjectMenuItem(DocumentTexts::notKept, DocumentTags.TROUBLE, "⚠ ") { choose(DocumentEvent.WarningShown(true)) }
        HorizontalDivider()
    }
    ProjectMenuItem(CommonTexts::newProject, DocumentTags.NEW) { choose(DocumentEvent.NewRequested) }
    for (brick in OTHER_BRICKS) {
        ProjectMenuItem(BrickLabels.of(brick).newProject, DocumentTags.new(brick)) {
            choose(DocumentEvent.NewWithBrick(brick))
        }
    }
    ProjectMenuItem(CommonTexts::myWork, DocumentTags.MY_WORK) { choose(DocumentEvent.ProjectListRequested) }
    ProjectMenuItem(DocumentTexts::open, DocumentTags.OPEN) { choose(DocumentEvent.OpenRequested) }
    ProjectMenuItem(DocumentTexts::openLink, DocumentTags.OPEN_LINK) { choose(DocumentEvent.LinkPastingRequested) }
    HorizontalDivider()
    ProjectMenuItem(DocumentTexts::rename, DocumentTags.RENAME) { choose(DocumentEvent.RenameRequested) }
    if (state.fileName != null) {
        ProjectMenuItem(DocumentTexts::save, DocumentTags.SAVE) { choose(DocumentEvent.SaveRequested) }
    }
    ProjectMenuItem(CommonTexts::saveAs, DocumentTags.SAVE_AS) { choose(DocumentEvent.SaveAsRequested) }
    ProjectMenuItem(DocumentTexts::share, DocumentTags.SHARE_LINK) { choose(DocumentEvent.LinkRequested) }
    HorizontalDivider()
    if (state.canSend) ProjectMenuItem(CommonTexts::sendToRobot, CommonTags.SEND_ROBOT) { choose(SendEvent.Requested) }
    ProjectMenuItem(CommonTexts::showWork, DocumentTags.SHOW) { choose(ExportEvent.Requested) }
    ProjectMenuItem(SchoolTexts::makeTitle, DocumentTags.MAKE_ASSIGNMENT) { choose(AssignmentEvent.MakingRequested) }
    ProjectMenuItem(DocumentTexts::replay, DocumentTags.REPLAY) { choose(DocumentEvent.ReplayRequested) }
    ProjectMenuItem(DocumentTexts::programFile, DocumentTags.PROGRAM_FILE) {
        choose(DocumentEvent.ProgramFileRequested)
    }
    val kit = if (state.hasFirmwareImage) NqcTexts::documentsFirmwareImage else CommonTexts::sendingKit
    ProjectMenuItem(kit, DocumentTags.KIT) { choose(DocumentEvent.KitRequested) }
    if (state.hasGoals) {
        HorizontalDivider()
        ProjectMenuItem(SchoolTexts::handInsMenu, HandInTags.HAND_INS) { choose(HandInsEvent.Requested) }
    }
}

@Composable
private fun ProjectMenuItem(label: Label, tag: String, sign: String = "", onClick: () -> Unit) {
    MenuItem(sign + label(spoken), DocumentTags.menuItem(tag), onClick = onClick)
}
