package robotran.ui.program

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import robotran.language.ShownLanguage
import robotran.programs.support
import robotran.projects.ProgramView
import robotran.robolang.words.Vocabulary
import robotran.ui.program.editor.EditorCommand
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.EditorTexts
import robotran.ui.programlanguages.translationTexts
import robotran.ui.texts.BrickLabels
import robotran.uikit.*
import robotran.workshop.state.ProgramsState

/** A slim row above the program: frequent actions, and a menu with the rest and with what has no room in the row. */
@Composable
internal fun EditorTools(
    state: ProgramsState,
    onTranslation: (Boolean, ShownLanguage) -> Unit,
    onView: (ProgramView) -> Unit,
    onSend: () -> Unit,
    onWords: (Vocabulary) -> Unit,
    onBlockWords: (inEnglish: Boolean) -> Unit,
    onCommand: (EditorCommand.Plain) -> Unit,
) {
    val support = state.program.language.support
    val send = BrickLabels.of(state.brick).send
    val translation = state.translationKind
    BoxWithConstraints(Modifier.fillMaxWidth().background(LocalRobotranColours.current.pane)) {
        val places = toolPlaces(maxWidth, support.hasBlocks, translation?.translationTexts?.switch, send)
        Row(
            Modifier.fillMaxWidth().heightIn(min = Dimensions.TARGET).padding(horizontal = ToolSizes.EDGE),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            UndoAndRedo(state, onCommand)
            if (places.hasFind) {
                IconButton(ThinIcons.FIND, EditorTexts.find(spoken), ProgramTags.FIND_OPEN, IconButtonKind.TOOL) {
                    onCommand(EditorCommand.Plain.FIND)
                }
            }
            Spacer(Modifier.weight(1f))
            if (support.hasBlocks) {
                ViewSwitch(state.view, onView)
                Spacer(Modifier.width(ToolSizes.GAP))
            }
            if (translation != null && places.hasTranslation) {
                PaneChip(
                    translation.translationTexts.switch(spoken),
                    ProgramTags.TRANSLATION_SWITCH,
                    state.translationShown,
                ) {
                    onTranslation(!state.translationShown, translation)
                }
                Spacer(Modifier.width(ToolSizes.GAP))
            }
            if (places.send != SendPlace.MENU) SendButton(send, places.send == SendPlace.WORDS, onSend)
            EditorMenu(state, places, onTranslation, onSend, onWords, onBlockWords, onCommand)
        }
    }
}

@Composable
private fun UndoAndRedo(state: ProgramsState, onCommand: (EditorCommand.Plain) -> Unit) {
    IconButton(
        ThinIcons.UNDO,
        EditorTexts.undo(spoken),
        ProgramTags.UNDO,
        IconButtonKind.TOOL,
        enabled = state.canUndo,
    ) {
        onCommand(EditorCommand.Plain.UNDO)
    }
    IconButton(
        ThinIcons.REDO,
        EditorTexts.redo(spoken),
        ProgramTags.REDO,
        IconButtonKind.TOOL,
        enabled = state.canRedo,
    ) {
        onCommand(EditorCommand.Plain.REDO)
    }
}
