package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.StoppedWork

/** Tells that work stopped the app when it was opened last. All other work is one touch away. */
@Composable
internal fun StoppedLastTimeDialog(dialog: DocumentDialog.StoppedLastTime, onEvent: (DocumentEvent) -> Unit) {
    val name = dialog.name.ifEmpty { stringResource(Res.string.documents_untitled) }
    val title = when (dialog.work) {
        is StoppedWork.Stored, StoppedWork.OfFiles -> stringResource(Res.string.documents_stopped_project, name)
        is StoppedWork.OfLink -> stringResource(Res.string.documents_stopped_link)
    }
    DialogFrame(
        title,
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            OtherButton(stringResource(Res.string.documents_stopped_open), "stopped-open") {
                onEvent(DocumentEvent.StoppedWorkOpened)
            }
            // Files are where they came from.
            if (dialog.work != StoppedWork.OfFiles) {
                OtherButton(stringResource(Res.string.documents_stopped_save), "stopped-save") {
                    onEvent(DocumentEvent.StoppedWorkSaved)
                }
            }
            MainButton(stringResource(Res.string.documents_my_work), "stopped-my-work") {
                onEvent(DocumentEvent.ProjectListRequested)
            }
        },
    ) { Explanation(stringResource(Res.string.documents_stopped_help), Modifier.testTag("stopped-help")) }
}
