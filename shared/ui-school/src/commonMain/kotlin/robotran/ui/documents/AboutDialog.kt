package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

/** What Robotran is, and which version. */
@Composable
internal fun AboutDialog(dialog: DocumentDialog.About, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        DocumentTexts.about(spoken),
        close,
        buttons = {
            Button(
                DocumentTexts.understood(spoken),
                DocumentTags.DOCUMENT_DONE,
                ButtonKind.DIALOG_MAIN,
                onClick = close,
            )
        },
    ) {
        if (dialog.version.isNotEmpty()) {
            Explanation(DocumentTexts.aboutVersion(spoken, dialog.version), Modifier.testTag(DocumentTags.VERSION))
        }
        Explanation(DocumentTexts.aboutHelp(spoken))
    }
}
