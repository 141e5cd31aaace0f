package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.StoppedWork

/** Tells that work stopped the app when it was opened last. All other work is one touch away. */
@Composable
internal fun StoppedLastTimeDialog(dialog: DocumentDialog.StoppedLastTime, onEvent: (DocumentEvent) -> Unit) {
    val name = dialog.name.ifEmpty { DocumentTexts.untitled(spoken) }
    val title = when (dialog.work) {
        is StoppedWork.Stored, StoppedWork.OfFiles -> DocumentTexts.stoppedProject(spoken, name)
        is StoppedWork.OfLink -> DocumentTexts.stoppedLink(spoken)
    }
    Dialog(
        title,
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            Button(DocumentTexts.stoppedOpen(spoken), DocumentTags.STOPPED_OPEN, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.StoppedWorkOpened)
            }
            // Files are where they came from.
            if (dialog.work != StoppedWork.OfFiles) {
                Button(DocumentTexts.stoppedSave(spoken), DocumentTags.STOPPED_SAVE, ButtonKind.DIALOG_OTHER) {
                    onEvent(DocumentEvent.StoppedWorkSaved)
                }
            }
            Button(CommonTexts.myWork(spoken), DocumentTags.STOPPED_MY_WORK, ButtonKind.DIALOG_MAIN) {
                onEvent(DocumentEvent.ProjectListRequested)
            }
        },
    ) { Explanation(DocumentTexts.stoppedHelp(spoken), Modifier.testTag(DocumentTags.STOPPED_HELP)) }
}
