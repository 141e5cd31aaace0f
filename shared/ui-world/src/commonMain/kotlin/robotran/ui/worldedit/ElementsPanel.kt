package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.ChoosingRow
import robotran.ui.editing.HelpText
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.worldediting.ElementKind
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEdit
import robotran.worldediting.listed

/** A list of all elements on the sheet. */
@Composable
internal fun ElementsPanel(editor: EditorScope, onChosen: () -> Unit) {
    HelpText(WorldEditorTexts.thingsHelp(spoken))
    for (thing in editor.world.listed()) if (thing.kind != ElementKind.GOAL) ElementRow(editor, thing, 0.dp, onChosen)
}

/** An element in a list. */
@Composable
internal fun ElementRow(editor: EditorScope, ref: ElementRef, indent: Dp, onChosen: () -> Unit) = ChoosingRow(
    elementText(editor.world, ref),
    WorldTags.thing(ref.kind, ref.number),
    isChosen = ref in editor.editing.selection,
    isWrong = editor.editing.errors.any { it.thing == ref },
    indent,
) {
    editor.make(WorldEdit.Select(ref, editor.editing.isMultiSelect))
    if (!editor.editing.isMultiSelect) onChosen()
}
