package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

/** Asks whether to go on with what is newer in My work, or to open the file as it is. Neither is lost. */
@Composable
internal fun NewerInMyWorkDialog(dialog: DocumentDialog.NewerInMyWork, onEvent: (DocumentEvent) -> Unit) {
    Dialog(
        DocumentTexts.newerTitle(spoken, dialog.fileName),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            Button(DocumentTexts.newerFile(spoken), DocumentTags.NEWER_FILE, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.WorkOrFileChosen(isWork = false))
            }
            Button(DocumentTexts.newerWork(spoken), DocumentTags.NEWER_WORK, ButtonKind.DIALOG_MAIN) {
                onEvent(DocumentEvent.WorkOrFileChosen(isWork = true))
            }
        },
    ) {
        Explanation(
            DocumentTexts.newerWorkTime(spoken, dialog.workTime),
            Modifier.testTag(DocumentTags.NEWER_TIMES),
        )
        dialog.fileTime?.let { Explanation(DocumentTexts.newerFileTime(spoken, it)) }
        Explanation(DocumentTexts.newerBoth(spoken))
    }
}
