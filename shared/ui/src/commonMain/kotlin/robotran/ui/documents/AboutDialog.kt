package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import org.jetbrains.compose.resources.stringResource
import robotran.ui.resources.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

/** What Robotran is, and which version. */
@Composable
internal fun AboutDialog(dialog: DocumentDialog.About, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    DialogFrame(
        stringResource(Res.string.documents_about),
        close,
        buttons = { MainButton(stringResource(Res.string.documents_understood), "document-done", onClick = close) },
    ) {
        if (dialog.version.isNotEmpty()) {
            Explanation(stringResource(Res.string.documents_about_version, dialog.version), Modifier.testTag("version"))
        }
        Explanation(stringResource(Res.string.documents_about_help))
    }
}
