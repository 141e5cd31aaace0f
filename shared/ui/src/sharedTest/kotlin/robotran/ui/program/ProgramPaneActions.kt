package robotran.ui.program

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performSemanticsAction
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.withKeyDown
import robotran.textediting.EditKind
import robotran.textediting.text.TextDocument
import robotran.textediting.text.TextSelection
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.pass
import robotran.workshop.Workshop
import robotran.workshop.event.ProgramEvent

internal fun Workshop.write(text: String, caret: Int = text.length, anchor: Int = caret) =
    handle(ProgramEvent.DraftChanged(TextDocument(text, TextSelection(anchor, caret)), EditKind.OTHER))

internal val Workshop.selected get() = state.programs.draft.selectedText
internal val Workshop.caret get() = state.programs.draft.selection.caret

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.focusProgram() {
    onNodeWithTag(ProgramTags.PROGRAM).performSemanticsAction(SemanticsActions.RequestFocus)
    pass(100)
}

/** A long press on [tag]; null for its centre. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.rest(tag: String, position: Offset? = null) {
    onNodeWithTag(tag).performTouchInput { down(position ?: center) }
    pass(800)
    onNodeWithTag(tag).performTouchInput { up() }
    pass(300)
}

@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.keys(keys: List<Key>, with: Key? = null) {
    onRoot().performKeyInput {
        val press = { keys.forEach { pressKey(it) } }
        if (with == null) press() else withKeyDown(with) { press() }
    }
    pass(100)
}

/** Presses the tool [tag] of the program. If the row of tools has no room for it, it is in their menu. */
@OptIn(ExperimentalTestApi::class)
internal fun ComposeUiTest.pressTool(tag: String) {
    if (onAllNodesWithTag(tag).fetchSemanticsNodes().isEmpty()) {
        onNodeWithTag(ProgramTags.EDITOR_MORE).performClick()
        pass(500)
    }
    onNodeWithTag(tag).performClick()
}
