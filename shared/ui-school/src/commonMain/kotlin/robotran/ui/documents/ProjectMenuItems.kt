package robotran.ui.documents

import androidx.compose.foundation.layout.heightIn
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
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
        ProjectMenuItem(DocumentTexts::notKept, "trouble", "⚠ ") { choose(DocumentEvent.WarningShown(true)) }
        HorizontalDivider()
    }
    ProjectMenuItem(CommonTexts::newProject, "new") { choose(DocumentEvent.NewRequested) }
    for (brick in OTHER_BRICKS) {
        ProjectMenuItem(BrickLabels.of(brick).newProject, "new-${brick.name.lowercase()}") {
            choose(DocumentEvent.NewWithBrick(brick))
        }
    }
    ProjectMenuItem(CommonTexts::myWork, "my-work") { choose(DocumentEvent.ProjectListRequested) }
    ProjectMenuItem(DocumentTexts::open, "open") { choose(DocumentEvent.OpenRequested) }
    ProjectMenuItem(DocumentTexts::openLink, "open-link") { choose(DocumentEvent.LinkPastingRequested) }
    HorizontalDivider()
    ProjectMenuItem(DocumentTexts::rename, "rename") { choose(DocumentEvent.RenameRequested) }
    if (state.fileName != null) {
        ProjectMenuItem(DocumentTexts::save, "save") { choose(DocumentEvent.SaveRequested) }
    }
    ProjectMenuItem(CommonTexts::saveAs, "save-as") { choose(DocumentEvent.SaveAsRequested) }
    ProjectMenuItem(DocumentTexts::share, "share-link") { choose(DocumentEvent.LinkRequested) }
    HorizontalDivider()
    if (state.canSend) ProjectMenuItem(CommonTexts::sendToRobot, "send-robot") { choose(SendEvent.Requested) }
    ProjectMenuItem(CommonTexts::showWork, "show") { choose(ExportEvent.Requested) }
    ProjectMenuItem(SchoolTexts::makeTitle, "make-assignment") { choose(AssignmentEvent.MakingRequested) }
    ProjectMenuItem(DocumentTexts::replay, "replay") { choose(DocumentEvent.ReplayRequested) }
    ProjectMenuItem(DocumentTexts::programFile, "program-file") { choose(DocumentEvent.ProgramFileRequested) }
    val kit = if (state.hasFirmwareImage) NqcTexts::documentsFirmwareImage else CommonTexts::sendingKit
    ProjectMenuItem(kit, "kit") { choose(DocumentEvent.KitRequested) }
    if (state.hasGoals) {
        HorizontalDivider()
        ProjectMenuItem(SchoolTexts::handInsMenu, "hand-ins") { choose(HandInsEvent.Requested) }
    }
}

@Composable
private fun ProjectMenuItem(label: Label, tag: String, sign: String = "", onClick: () -> Unit) {
    MenuItem(sign + label(spoken), "work-$tag", onClick = onClick)
}
