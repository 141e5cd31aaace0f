package robotran.ui.documents

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import robotran.documents.OpenFilesError
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.texts.CommonTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentAnswer
import robotran.workshop.state.DocumentDialog
import robotran.workshop.state.DocumentState
import robotran.workshop.state.Notice

/** The open dialog of the document, if any. [noticeText] says what a notice says. */
@Composable
fun DocumentDialogs(
    state: DocumentState,
    noticeText: @Composable (Notice) -> String,
    onEvent: (DocumentEvent) -> Unit,
) {
    when (val dialog = state.dialog) {
        null -> Unit
        is DocumentDialog.RobotChoice -> RobotChoiceDialog(dialog.board, onEvent)
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
    Dialog(
        DocumentTexts.changedTitle(spoken, dialog.fileName),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            Button(DocumentTexts.changedTheirs(spoken), DocumentTags.CHANGED_THEIRS, ButtonKind.DIALOG_OTHER) {
                answer(DocumentAnswer.TAKE_THEIRS)
            }
            Button(DocumentTexts.changedOver(spoken), DocumentTags.CHANGED_OVER, ButtonKind.DIALOG_OTHER) {
                answer(DocumentAnswer.GO_ON)
            }
            Button(
                DocumentTexts.changedAs(spoken),
                DocumentTags.CHANGED_AS,
                ButtonKind.DIALOG_MAIN,
            ) { answer(DocumentAnswer.SAVE_AS) }
        },
    ) { Explanation(DocumentTexts.changedHelp(spoken)) }
}

@Composable
private fun WouldBeLostDialog(onEvent: (DocumentEvent) -> Unit) {
    Dialog(
        DocumentTexts.lossTitle(spoken),
        onClose = { onEvent(DocumentEvent.DialogClosed) },
        buttons = {
            Button(DocumentTexts.cancel(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.DialogClosed)
            }
            Button(DocumentTexts.lossGoOn(spoken), DocumentTags.LOSS_GO_ON, ButtonKind.DIALOG_OTHER) {
                onEvent(DocumentEvent.Answered(DocumentAnswer.GO_ON))
            }
            Button(CommonTexts.saveAs(spoken), DocumentTags.LOSS_SAVE_AS, ButtonKind.DIALOG_MAIN) {
                onEvent(DocumentEvent.Answered(DocumentAnswer.SAVE_AS))
            }
        },
    ) { Explanation(DocumentTexts.lossHelp(spoken)) }
}

@Composable
private fun RejectedDialog(dialog: DocumentDialog.Rejected, onEvent: (DocumentEvent) -> Unit) {
    val close = { onEvent(DocumentEvent.DialogClosed) }
    Dialog(
        DocumentTexts.refusedTitle(spoken),
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
        Explanation(wordsFor(dialog.error), Modifier.testTag(DocumentTags.DOCUMENT_TROUBLE))
        Explanation(DocumentTexts.refusedHelp(spoken))
    }
}

@Composable
internal fun wordsFor(error: OpenFilesError): String = when (error) {
    is OpenFilesError.InFile -> DocumentTexts.refusedFile(spoken, error.file, error.message)
    is OpenFilesError.InLink -> error.message
    is OpenFilesError.NotText -> DocumentTexts.refusedText(spoken, error.file)
    OpenFilesError.SeveralRobots -> DocumentTexts.refusedRobots(spoken)
    OpenFilesError.SeveralWorlds -> DocumentTexts.refusedWorlds(spoken)
    is OpenFilesError.TooLong -> DocumentTexts.refusedLong(spoken, error.file)
    is OpenFilesError.TooManyPrograms -> DocumentTexts.refusedMany(spoken, error.max)
    is OpenFilesError.UnknownKind -> DocumentTexts.refusedKind(spoken, error.file)
}
