package robotran.ui.documents

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.MutableState
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.ImeAction
import androidx.compose.ui.text.input.TextFieldValue
import robotran.ui.school.tags.DocumentTags
import robotran.ui.school.texts.DocumentTexts
import robotran.uikit.*
import robotran.workshop.event.DocumentEvent
import robotran.workshop.state.DocumentDialog

@Composable
internal fun RenameDialog(dialog: DocumentDialog.Renaming, onEvent: (DocumentEvent) -> Unit) {
    val name = remember { mutableStateOf(TextFieldValue(dialog.name, TextRange(0, dialog.name.length))) }
    TextDialog(
        title = DocumentTexts.renameTitle(spoken),
        label = DocumentTexts.nameLabel(spoken),
        typed = name,
        doneWords = DocumentTexts.nameDone(spoken),
        onDone = { onEvent(DocumentEvent.Renamed(it)) },
        onEvent = onEvent,
    )
}

@Composable
internal fun PasteLinkDialog(dialog: DocumentDialog.PastingLink, onEvent: (DocumentEvent) -> Unit) {
    val link = remember { mutableStateOf(TextFieldValue()) }
    TextDialog(
        title = DocumentTexts.pasteTitle(spoken),
        label = DocumentTexts.linkLabel(spoken),
        typed = link,
        doneWords = DocumentTexts.pasteDone(spoken),
        onDone = { onEvent(DocumentEvent.LinkOpened(it)) },
        onEvent = onEvent,
        help = DocumentTexts.pasteHelp(spoken),
        error = dialog.error,
    )
}

/** A dialog with a one-line text field; Enter confirms. */
@Composable
private fun TextDialog(
    title: String,
    label: String,
    typed: MutableState<TextFieldValue>,
    doneWords: String,
    onDone: (String) -> Unit,
    onEvent: (DocumentEvent) -> Unit,
    help: String? = null,
    error: String? = null,
) {
    var value by typed
    val close = { onEvent(DocumentEvent.DialogClosed) }
    val mayBeDone = value.text.isNotBlank()
    val done = { onDone(value.text) }
    Dialog(
        title,
        close,
        buttons = {
            Button(DocumentTexts.cancel(spoken), DocumentTags.DOCUMENT_CANCEL, ButtonKind.DIALOG_OTHER, onClick = close)
            Button(doneWords, DocumentTags.DOCUMENT_DONE, ButtonKind.DIALOG_MAIN, enabled = mayBeDone, onClick = done)
        },
    ) {
        if (help != null) Explanation(help)
        OneLine(value, { value = it }, label, error != null) { if (mayBeDone) done() }
        if (error != null) {
            val announced = Modifier.testTag(DocumentTags.DOCUMENT_TROUBLE).announced()
            Explanation(error, announced, bad = true)
        }
    }
}

/** A text field of one line that has the focus at once. */
@Composable
internal fun OneLine(
    value: TextFieldValue,
    onValue: (TextFieldValue) -> Unit,
    label: String,
    isError: Boolean,
    onReturn: () -> Unit,
) {
    val focus = remember { FocusRequester() }
    LaunchedEffect(Unit) { focus.requestFocus() }
    TextField(
        value,
        onValue,
        Modifier.fillMaxWidth().focusRequester(focus).testTag(DocumentTags.DOCUMENT_TEXT).onPreviewKeyEvent {
            val isReturn = it.key == Key.Enter || it.key == Key.NumPadEnter
            if (isReturn && it.type == KeyEventType.KeyDown) onReturn()
            isReturn
        },
        label,
        keyboard = KeyboardOptions(imeAction = ImeAction.Done),
        onKeyboard = KeyboardActions(onDone = { onReturn() }),
        extras = FieldExtras(isError),
    )
}
