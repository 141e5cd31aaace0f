package robotran.ui.worldedit

import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.ExperimentalLayoutApi
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.heading
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.worldediting.AlignSide
import robotran.worldediting.ElementKind
import robotran.worldediting.StackOrder
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing
import robotran.worldediting.canRotate
import robotran.worldediting.form
import robotran.worldediting.piece

/** The selection: its actions and properties. */
@Composable
internal fun ChosenPanel(editor: EditorScope) {
    val editing = editor.editing
    if (editing.selection.isEmpty()) {
        HelpText(WorldEditorTexts.chooseFirst(spoken))
        return
    }
    val only = editing.only
    Text(chosenTitle(editing), Modifier.testTag("chosen-name").heading(), TextStyles.lead.strong)
    Actions(editor)
    HorizontalDivider()
    val piece = only?.let { editing.world.piece(it) }
    if (only != null && piece != null) ElementFields(editor, only, piece)
    if (editing.hasPlace) {
        RowHeading(if (only != null) WorldEditorTexts.alignPaper(spoken) else WorldEditorTexts.align(spoken))
        AlignRow(editor)
    }
}

@Composable
private fun chosenTitle(editing: WorldEditing): String {
    val only = editing.only ?: return WorldEditorTexts.severalChosen(spoken, editing.selection.size)
    return elementText(editing.world, only)
}

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun Actions(editor: EditorScope) {
    val editing = editor.editing
    val turn = turnStep(editing)
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        Action(EditIcons.DELETE, WorldEditorTexts::delete, "delete") { editor.make(WorldEdit.Delete) }
        Action(EditIcons.COPY, WorldEditorTexts::duplicate, "duplicate") { editor.make(WorldEdit.Duplicate) }
        if (editing.canRotate) {
            Action(EditIcons.TURN_LEFT, WorldEditorTexts::turnLeft, "turn-left") { editor.make(WorldEdit.TurnBy(turn)) }
            Action(EditIcons.TURN_RIGHT, WorldEditorTexts::turnRight, "turn-right") {
                editor.make(WorldEdit.TurnBy(-turn))
            }
        }
        if (editing.selection.any { it.kind != ElementKind.ROBOT && it.kind != ElementKind.LAMP } && editing.hasPlace) {
            Action(EditIcons.LARGER, WorldEditorTexts::larger, "larger") { editor.make(WorldEdit.ScaleBy(GROWTH)) }
            Action(EditIcons.SMALLER, WorldEditorTexts::smaller, "smaller") {
                editor.make(WorldEdit.ScaleBy(1 / GROWTH))
            }
        }
        if (editing.selection.any { it.kind == ElementKind.MARK }) {
            Action(EditIcons.FRONT, WorldEditorTexts::toFront, "to-front") {
                editor.make(WorldEdit.Restack(StackOrder.TO_FRONT))
            }
            Action(EditIcons.UP, WorldEditorTexts::forward, "forward") {
                editor.make(WorldEdit.Restack(StackOrder.FORWARD))
            }
            Action(EditIcons.DOWN, WorldEditorTexts::backward, "backward") {
                editor.make(WorldEdit.Restack(StackOrder.BACK))
            }
            Action(EditIcons.BACK, WorldEditorTexts::toBack, "to-back") {
                editor.make(WorldEdit.Restack(StackOrder.TO_BACK))
            }
        }
        if (editing.selection.size > 1) {
            Action(EditIcons.GROUP, WorldEditorTexts::group, "group") { editor.make(WorldEdit.Group) }
        }
        if (editing.groups.any { group -> group.any { it in editing.selection } }) {
            Action(EditIcons.UNGROUP, WorldEditorTexts::ungroup, "ungroup") { editor.make(WorldEdit.Ungroup) }
        }
    }
}

@Composable
private fun Action(icon: Icon, word: Label, tag: String, onClick: () -> Unit) =
    IconWord(icon, word(spoken), tag, onClick)

@OptIn(ExperimentalLayoutApi::class)
@Composable
private fun AlignRow(editor: EditorScope) {
    FlowRow(Modifier.fillMaxWidth(), Arrangement.spacedBy(2.dp)) {
        for (side in AlignSide.entries) {
            val tag = "align-${side.name.lowercase()}"
            IconWord(alignIcon(side), alignWord(side)(spoken), tag, { editor.make(WorldEdit.Align(side)) })
        }
    }
}

/** Whether a selected element has a place on the sheet. */
private val WorldEditing.hasPlace: Boolean get() = selection.any { world.piece(it)?.form != null }

private val WorldEditing.canRotate: Boolean
    get() = if (selection.size > 1) hasPlace else selection.any { world.piece(it)?.form?.canRotate == true }

private fun alignWord(side: AlignSide): Label = when (side) {
    AlignSide.LEFT -> WorldEditorTexts::alignLeft
    AlignSide.CENTRE -> WorldEditorTexts::alignCentre
    AlignSide.RIGHT -> WorldEditorTexts::alignRight
    AlignSide.TOP -> WorldEditorTexts::alignTop
    AlignSide.MIDDLE -> WorldEditorTexts::alignMiddle
    AlignSide.BOTTOM -> WorldEditorTexts::alignBottom
}
