package robotran.ui.program.blocks.dialogs

import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.text.input.ImeAction
import robotran.blockediting.BlockEdit
import robotran.robolang.outline.PhrasePart
import robotran.ui.program.blocks.BlockScope
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*

/** The comment of the line [line]. */
@Composable
internal fun NoteDialog(line: Int, scope: BlockScope, onClose: () -> Unit, modifier: Modifier) {
    val comment = scope.state.program.outline.lines.getOrNull(line)?.comment
    val now = comment?.let { scope.textOf(it).removePrefix("//").trim() }
    BlockDialogFrame(BlockTexts.note(spoken), onClose, modifier) {
        DialogField(now.orEmpty(), BlockTexts.note(spoken), ProgramTags.NOTE) {
            scope.edit(BlockEdit.SetNote(line, it.takeIf { text -> text.isNotBlank() }))
            onClose()
        }
        if (now != null) {
            DialogButton(BlockTexts.noteDelete(spoken), ProgramTags.NOTE_DELETE) {
                scope.edit(BlockEdit.SetNote(line, null))
                onClose()
            }
        }
    }
}

/** The text of the line [line], to put right what is no block. */
@Composable
internal fun LineDialog(line: Int, scope: BlockScope, onClose: () -> Unit, modifier: Modifier) {
    val now = scope.state.program.outline.lines.getOrNull(line)?.let { scope.textOf(it.span).trim() }.orEmpty()
    BlockDialogFrame(BlockTexts.line(spoken), onClose, modifier) {
        DialogField(now, BlockTexts.line(spoken), ProgramTags.LINE) {
            scope.edit(BlockEdit.ReplaceLine(line, it))
            onClose()
        }
    }
}

/** The text that `show` puts on the display. */
@Composable
internal fun ShownTextDialog(part: PhrasePart.Text, scope: BlockScope, onClose: () -> Unit) {
    val title = BlockTexts.shownText(spoken)
    BlockDialogFrame(title, onClose) {
        DialogField(scope.textOf(part).removeSurrounding("\""), title, ProgramTags.SHOWN_TEXT) {
            scope.put(it)
            onClose()
        }
    }
}

/**
 * A field with a button that takes what is in it. It has the focus when it appears.
 *
 * @param onDone receives the text.
 */
@Composable
internal fun DialogField(
    text: String,
    label: String,
    tag: String,
    takesFocus: Boolean = true,
    onDone: (String) -> Unit,
) {
    var typed by remember(text) { mutableStateOf(text) }
    val focus = remember { FocusRequester() }
    TextField(
        typed,
        { typed = it },
        Modifier.fillMaxWidth().focusRequester(focus).testTag(ProgramTags.field(tag)),
        label,
        keyboard = KeyboardOptions(imeAction = ImeAction.Done),
        onKeyboard = KeyboardActions(onDone = { onDone(typed) }),
    )
    DialogButton(BlockTexts.done(spoken), ProgramTags.done(tag)) { onDone(typed) }
    LaunchedEffect(Unit) { if (takesFocus) focus.requestFocus() }
}
