package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import org.jetbrains.compose.resources.stringResource
import robotran.documents.OpenFilesError
import robotran.ui.resources.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.DocumentState
import robotran.workshop.state.Notice

/** The open dialog of the document, if any. [noticeText] says what a notice says. */
@Composable
internal fun DocumentDialogs(
    state: DocumentState,
    noticeText: @Composable (Notice) -> String,
    onEvent: (DocumentEvent) -> Unit,
) {
    when (val dialog = state.dialog) {
        null -> Unit
        is DocumentDialog.Renaming -> RenameDialog(dialog, onEvent)
        is DocumentDialog.ProjectList -> ProjectsDialog(dialog, noticeText, onEvent)
        is DocumentDialog.SharingLink -> ShareLinkDialog(dialog, state.hasShareSheet, onEvent)
        DocumentDialog.SharingFile -> ShareFileDialog(onEvent)
        is DocumentDialog.PastingLink -> PasteLinkDialog(dialog, onEvent)
        is DocumentDialog.ChangedElsewhere -> ChangedMeanwhileDialog(dialog, onEvent)
        DocumentDialog.WouldBeLost -> WouldBeLostDialog(onEvent)
        is DocumentDialog.About -> AboutDialog(dialog, onEvent)
        is DocumentDialog.NewerInMyWork -> NewerInMyWorkDialog(dialog, onEvent)
        is DocumentDialog.StoppedLastTime -> StoppedLastTimeDialog(dialog, onEvent)
        is DocumentDialog.Rejected -> RejectedDialog(dialog, onEvent)
    }
}

@Composable
private fun ChangedMeanwhileDialog(dialog: DocumentDialog.ChangedElsewhere, onEvent: (DocumentEvent) -> Unit) {
    val answer = { answer: DocumentAnswer -> onEvent(DocumentEvent.Answered(answer)) }
    DialogFrame(
        stringResource(Res.string.documents_changed_title, dialog.fileName),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            OtherButton(stringResource(Res.string.documents_changed_theirs), "changed-theirs") {
                answer(DocumentAnswer.TAKE_THEIRS)
            }
            OtherButton(stringResource(Res.string.documents_changed_over), "changed-over") {
                answer(DocumentAnswer.GO_ON)
            }
            MainButton(stringResource(Res.string.documents_changed_as), "changed-as") { answer(DocumentAnswer.SAVE_AS) }
        },
    ) { Explanation(stringResource(Res.string.documents_changed_help)) }
}

@Composable
private fun WouldBeLostDialog(onEvent: (DocumentEvent) -> Unit) {
    DialogFrame(
        stringResource(Res.string.documents_loss_title),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            OtherButton(stringResource(Res.string.documents_cancel), "document-cancel") {
                onEvent(DocumentEvent.DialogClosed)
            }
            OtherButton(stringResource(Res.string.documents_loss_go_on), "loss-go-on") {
                onEvent(DocumentEvent.Answered(DocumentAnswer.GO_ON))
            }
            MainButton(stringResource(Res.string.documents_save_as), "loss-save-as") {
                onEvent(DocumentEvent.Answered(DocumentAnswer.SAVE_AS))
            }
        },
    ) { Explanation(stringResource(Res.string.documents_loss_help)) }
}

@Composable
private fun RejectedDialog(dialog: DocumentDialog.Rejected, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    DialogFrame(
        stringResource(Res.string.documents_refused_title),
        close,
        buttons = { MainButton(stringResource(Res.string.documents_understood), "document-done", onClick = close) },
    ) {
        Explanation(wordsFor(dialog.error), Modifier.testTag("document-trouble"))
        Explanation(stringResource(Res.string.documents_refused_help))
    }
}

@Composable
internal fun wordsFor(error: OpenFilesError): String = when (error) {
    is OpenFilesError.InFile -> stringResource(Res.string.documents_refused_file, error.file, error.message)
    is OpenFilesError.InLink -> error.message
    is OpenFilesError.NotText -> stringResource(Res.string.documents_refused_text, error.file)
    OpenFilesError.SeveralRobots -> stringResource(Res.string.documents_refused_robots)
    OpenFilesError.SeveralWorlds -> stringResource(Res.string.documents_refused_worlds)
    is OpenFilesError.TooLong -> stringResource(Res.string.documents_refused_long, error.file)
    is OpenFilesError.TooManyPrograms -> stringResource(Res.string.documents_refused_many, error.max)
    is OpenFilesError.UnknownKind -> stringResource(Res.string.documents_refused_kind, error.file)
}
