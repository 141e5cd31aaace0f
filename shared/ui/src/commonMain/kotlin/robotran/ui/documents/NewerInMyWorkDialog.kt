package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

/** Asks whether to go on with what is newer in My work, or to open the file as it is. Neither is lost. */
@Composable
internal fun NewerInMyWorkDialog(dialog: DocumentDialog.NewerInMyWork, onEvent: (DocumentEvent) -> Unit) {
    DialogFrame(
        stringResource(Res.string.documents_newer_title, dialog.fileName),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            OtherButton(stringResource(Res.string.documents_newer_file), "newer-file") {
                onEvent(DocumentEvent.WorkOrFileChosen(isWork = false))
            }
            MainButton(stringResource(Res.string.documents_newer_work), "newer-work") {
                onEvent(DocumentEvent.WorkOrFileChosen(isWork = true))
            }
        },
    ) {
        Explanation(
            stringResource(Res.string.documents_newer_work_time, dialog.workTime),
            Modifier.testTag("newer-times"),
        )
        dialog.fileTime?.let { Explanation(stringResource(Res.string.documents_newer_file_time, it)) }
        Explanation(stringResource(Res.string.documents_newer_both))
    }
}
