package robotran.ui.program

import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.text.KeyboardActions
import androidx.compose.foundation.text.KeyboardOptions
import androidx.compose.material3.OutlinedTextField
import androidx.compose.material3.Text
import androidx.compose.material3.TextButton
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
import org.jetbrains.compose.resources.StringResource
import org.jetbrains.compose.resources.stringResource
import robotran.language.ProgramLanguage
import robotran.ui.documents.DialogFrame
import robotran.ui.parts.fieldColours
import robotran.ui.resources.*
import robotran.ui.theme.Dimensions
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.TextSizes
import robotran.ui.theme.focusRing
import robotran.workshop.programs.NameProblem
import robotran.workshop.programs.endingOf
import robotran.workshop.programs.nameProblem
import robotran.workshop.state.ProgramsState

/** Asks for a new name of the current file. One of several classes can also be removed by [onRemove]. */
@Composable
internal fun RenameDialog(state: ProgramsState, onName: (String) -> Unit, onRemove: () -> Unit, onLeave: () -> Unit) {
    val ending = endingOf(state.file.name, state.program.language)
    val old = state.file.name.removeSuffix(ending)
    var typed by remember { mutableStateOf(TextFieldValue(old, TextRange(0, old.length))) }
    val problem = nameProblem(state.programs, state.shownProgram, state.shownFile, typed.text)
    val take = { if (problem == null) onName(typed.text) }
    val focus = remember { FocusRequester() }
    DialogFrame(
        stringResource(Res.string.editor_rename),
        onLeave,
        buttons = {
            DialogButton(stringResource(Res.string.editor_rename_cancel), "rename-cancel", true, onLeave)
            DialogButton(stringResource(Res.string.editor_rename_done), "rename-done", problem == null) { take() }
        },
    ) {
        // A dialog is composed separately: only now does the field exist.
        LaunchedEffect(Unit) { focus.requestFocus() }
        OutlinedTextField(
            typed,
            { typed = it },
            Modifier.fillMaxWidth().focusRequester(focus).testTag("rename-name"),
            label = { Text(stringResource(Res.string.editor_name)) },
            suffix = { Text(ending) },
            supportingText = { problem?.let { Text(stringResource(wordsFor(it))) } },
            isError = problem != null,
            singleLine = true,
            keyboardOptions = KeyboardOptions(imeAction = ImeAction.Done, autoCorrectEnabled = false),
            keyboardActions = KeyboardActions(onDone = { take() }),
            colors = fieldColours(),
        )
        if (state.program.files.size > 1) {
            val isJava = state.program.language == ProgramLanguage.JAVA
            val remove = if (isJava) Res.string.editor_remove_class else Res.string.editor_remove_file
            DialogButton(stringResource(remove), "remove-class", true, onRemove)
        }
    }
}

@Composable
private fun DialogButton(words: String, tag: String, enabled: Boolean, onClick: () -> Unit) {
    val colours = LocalRobotranColours.current
    TextButton(onClick, Modifier.defaultMinSize(minHeight = Dimensions.TARGET).testTag(tag).focusRing(), enabled) {
        Text(words, color = if (enabled) colours.focus else colours.quiet, fontSize = TextSizes.BODY)
    }
}

private fun wordsFor(problem: NameProblem): StringResource = when (problem) {
    NameProblem.EMPTY -> Res.string.editor_name_empty
    NameProblem.TAKEN -> Res.string.editor_name_taken
    NameProblem.NO_CLASS_NAME -> Res.string.editor_name_no_class
    NameProblem.STRANGE_CHARACTER -> Res.string.editor_name_strange
}
