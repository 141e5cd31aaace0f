package robotran.ui.program.editor

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusDirection
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.onPreviewKeyEvent
import androidx.compose.ui.input.key.type
import androidx.compose.ui.platform.LocalFocusManager
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.CustomAccessibilityAction
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.customActions
import androidx.compose.ui.semantics.semantics
import robotran.textediting.text.TextDocument
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.uikit.*

/** Keyboard input and semantics of an editor. */
@Composable
internal fun Modifier.editorInput(
    control: EditorControl,
    focus: FocusRequester,
    draft: TextDocument,
    onCommand: (EditorCommand) -> Unit,
    onBreakpoint: (Int) -> Unit,
    onFocus: (Boolean) -> Unit,
): Modifier {
    val label = EditorTexts.programLabel(spoken)
    val stopHere = EditorTexts.breakpoint(spoken)
    val focusManager = LocalFocusManager.current
    val line = draft.lines.lineOf(draft.selection.caret) + 1
    return focusRequester(focus)
        .onFocusChanged { onFocus(it.hasFocus) }
        .testTag(ProgramTags.PROGRAM)
        .semantics {
            contentDescription = label
            customActions = listOf(
                CustomAccessibilityAction(stopHere) {
                    onBreakpoint(line)
                    true
                },
            )
        }
        .onPreviewKeyEvent { event -> handleKey(event, control, onCommand) { focusManager.moveFocus(it) } }
}

private fun handleKey(
    event: KeyEvent,
    control: EditorControl,
    onCommand: (EditorCommand) -> Unit,
    onLeave: (FocusDirection) -> Unit,
): Boolean {
    val command = commandFor(event)
    val isEnter = event.key == Key.Enter || event.key == Key.NumPadEnter
    val isTab = event.key == Key.Tab
    if (event.type != KeyEventType.KeyDown) return isTab || (command != null && !leavesToField(command, control))
    if (control.performOnOffered(command, isEnter && command == null)) return true
    return when {
        isTab && !control.isEditing -> {
            onLeave(if (command == EditorCommand.Plain.UNINDENT) FocusDirection.Previous else FocusDirection.Next)
            true
        }

        command == null || leavesToField(command, control) -> false

        command == EditorCommand.Plain.LEAVE -> {
            onCommand(command)
            control.isEditing = false
            true
        }

        else -> {
            if (!control.perform(command)) onCommand(command)
            true
        }
    }
}

/** In a browser only the field itself can use the clipboard, which works if it contains the whole selection. */
private fun leavesToField(command: EditorCommand, control: EditorControl): Boolean =
    command in CLIPBOARD && control.link.containsSelection

private val CLIPBOARD =
    setOf<EditorCommand>(EditorCommand.Plain.CUT, EditorCommand.Plain.COPY, EditorCommand.Plain.PASTE)
