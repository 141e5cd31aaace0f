package robotran.ui.handins

import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.selection.selectable
import androidx.compose.foundation.selection.selectableGroup
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.unit.dp
import robotran.ui.school.tags.HandInTags
import robotran.ui.school.texts.DocumentTexts
import robotran.ui.school.texts.SchoolTexts
import robotran.uikit.*
import robotran.workshop.event.HandInsEvent
import robotran.workshop.state.HandInsDialog
import robotran.workshop.state.HandInsState

/** The open dialog over the hand-ins, if any. */
@Composable
internal fun HandInsDialogs(state: HandInsState, onEvent: (HandInsEvent) -> Unit) {
    when (val dialog = state.dialog) {
        null -> Unit
        HandInsDialog.Comparing -> CompareDialog(state, onEvent)
        HandInsDialog.PastingLinks -> PasteLinksDialog(onEvent)
        is HandInsDialog.Removing -> RemoveDialog(dialog.count, onEvent)
    }
}

@Composable
private fun PasteLinksDialog(onEvent: (HandInsEvent) -> Unit) {
    var text by remember { mutableStateOf(TextFieldValue()) }
    val close = { onEvent(HandInsEvent.DialogClosed) }
    Dialog(
        SchoolTexts.handInsPasteTitle(spoken),
        close,
        buttons = {
            Button(
                DocumentTexts.cancel(spoken),
                HandInTags.HAND_INS_PASTE_CANCEL,
                ButtonKind.DIALOG_OTHER,
                onClick = close,
            )
            Button(
                SchoolTexts.handInsPasteDone(spoken),
                HandInTags.HAND_INS_PASTE_DONE,
                ButtonKind.DIALOG_MAIN,
                enabled = text.text.isNotBlank(),
            ) {
                onEvent(HandInsEvent.LinksPasted(text.text))
            }
        },
    ) {
        val focus = remember { FocusRequester() }
        LaunchedEffect(Unit) { focus.requestFocus() }
        Explanation(SchoolTexts.handInsPasteHelp(spoken))
        TextField(
            text,
            { text = it },
            Modifier.fillMaxWidth()
                .heightIn(max = MAX_HEIGHT)
                .tabLeaves()
                .focusRequester(focus)
                .testTag(HandInTags.HAND_INS_LINKS),
            SchoolTexts.handInsPasteLabel(spoken),
            LINES..Int.MAX_VALUE,
        )
    }
}

@Composable
private fun RemoveDialog(count: Int, onEvent: (HandInsEvent) -> Unit) {
    val close = { onEvent(HandInsEvent.DialogClosed) }
    Dialog(
        SchoolTexts.handInsRemoveTitle(spoken),
        close,
        buttons = {
            Button(
                DocumentTexts.cancel(spoken),
                HandInTags.HAND_INS_REMOVE_CANCEL,
                ButtonKind.DIALOG_OTHER,
                onClick = close,
            )
            Button(SchoolTexts.handInsRemove(spoken), HandInTags.HAND_INS_REMOVE_DONE, ButtonKind.DIALOG_MAIN) {
                onEvent(HandInsEvent.RemovalConfirmed)
            }
        },
    ) { Explanation(SchoolTexts.handInsRemoveHelp(spoken, count)) }
}

/** Asks which hand-in to put beside the open one. */
@Composable
private fun CompareDialog(state: HandInsState, onEvent: (HandInsEvent) -> Unit) {
    val close = { onEvent(HandInsEvent.DialogClosed) }
    Dialog(
        SchoolTexts.handInBesideTitle(spoken),
        close,
        buttons = {
            Button(
                DocumentTexts.cancel(spoken),
                HandInTags.HAND_IN_BESIDE_CANCEL,
                ButtonKind.DIALOG_OTHER,
                onClick = close,
            )
        },
    ) {
        Column(Modifier.fillMaxWidth().selectableGroup()) {
            val alike = state.openedRow?.alike.orEmpty().associate { it.id to it.isEqual }
            state.comparable.forEachIndexed { index, row ->
                val isChosen = row.id == state.opened?.beside
                Row(
                    Modifier
                        .fillMaxWidth()
                        .testTag(HandInTags.besideChoice(index))
                        .defaultMinSize(minHeight = Dimensions.TARGET)
                        .focusRing()
                        .selectable(isChosen, role = Role.RadioButton) {
                            onEvent(HandInsEvent.ComparisonChosen(row.id))
                        },
                    verticalAlignment = Alignment.CenterVertically,
                ) {
                    RadioMark(isChosen, Modifier.padding(Space.MEDIUM))
                    Column {
                        NameLines(row)
                        alike[row.id]?.let { isEqual ->
                            RemarkLine(
                                if (isEqual) {
                                    SchoolTexts.handInBesideEqual(
                                        spoken,
                                    )
                                } else {
                                    SchoolTexts.handInBesideAlike(spoken)
                                },
                            )
                        }
                    }
                }
            }
        }
    }
}

private const val LINES = 4
private val MAX_HEIGHT = 260.dp
