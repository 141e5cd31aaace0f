package robotran.ui.program

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
import androidx.compose.ui.text.TextRange
import androidx.compose.ui.text.input.ImeAction
import androidx.compose.ui.text.input.TextFieldValue
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.programlanguages.texts
import robotran.uikit.*
import robotran.workshop.programs.NameError
import robotran.workshop.programs.nameError
import robotran.workshop.service.endingOf
import robotran.workshop.state.ProgramsState

/** Asks for a new name of the current file. One of several classes can also be removed by [onRemove]. */
@Composable
internal fun RenameDialog(state: ProgramsState, onName: (String) -> Unit, onRemove: () -> Unit, onLeave: () -> Unit) {
    val ending = endingOf(state.file.name, state.program.language)
    val old = state.file.name.removeSuffix(ending)
    var typed by remember { mutableStateOf(TextFieldValue(old, TextRange(0, old.length))) }
    val problem = nameError(state.programs, state.shownProgram, state.shownFile, typed.text)
    val take = { if (problem == null) onName(typed.text) }
    val focus = remember { FocusRequester() }
    Dialog(
        EditorTexts.rename(spoken),
        onLeave,
        buttons = {
            Button(
                EditorTexts.renameCancel(spoken),
                ProgramTags.RENAME_CANCEL,
                ButtonKind.LINK,
                style = TextStyles.body,
                onClick = onLeave,
            )
            Button(
                EditorTexts.renameDone(spoken),
                ProgramTags.RENAME_DONE,
                ButtonKind.LINK,
                enabled = problem == null,
                style = TextStyles.body,
            ) { take() }
        },
    ) {
        // A dialog is composed separately: only now does the field exist.
        LaunchedEffect(Unit) { focus.requestFocus() }
        TextField(
            typed,
            { typed = it },
            Modifier.fillMaxWidth().focusRequester(focus).testTag(ProgramTags.RENAME_NAME),
            EditorTexts.name(spoken),
            keyboard = KeyboardOptions(imeAction = ImeAction.Done, autoCorrectEnabled = false),
            onKeyboard = KeyboardActions(onDone = { take() }),
            extras = FieldExtras(problem != null, suffix = ending) { problem?.let { Text(wordsFor(it)(spoken)) } },
        )
        if (state.program.files.size > 1) {
            val remove = state.program.language.texts.removeFile
            Button(
                remove(spoken),
                ProgramTags.REMOVE_CLASS,
                ButtonKind.LINK,
                style = TextStyles.body,
                onClick = onRemove,
            )
        }
    }
}

private fun wordsFor(problem: NameError): Label = when (problem) {
    NameError.EMPTY -> EditorTexts::nameEmpty
    NameError.TAKEN -> EditorTexts::nameTaken
    NameError.NO_CLASS_NAME -> EditorTexts::nameNoClass
    NameError.STRANGE_CHARACTER -> EditorTexts::nameStrange
}
