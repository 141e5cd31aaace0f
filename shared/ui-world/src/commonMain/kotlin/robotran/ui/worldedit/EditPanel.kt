package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.key
import androidx.compose.ui.Modifier
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.EditorTab
import robotran.ui.editing.FieldPanel
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*

/** The tabs of the editor's panel. */
internal enum class EditTab(override val title: Label) : EditorTab {
    CHOSEN(WorldEditorTexts::tabChosen),
    THINGS(WorldEditorTexts::tabThings),
    GOALS(WorldEditorTexts::tabGoals),
    WORLD(WorldEditorTexts::tabWorld),
    ;

    override val tag get() = WorldTags.editTab(this)
}

@Composable
internal fun EditPanel(editor: EditorScope, tab: EditTab, onTab: (EditTab) -> Unit, modifier: Modifier = Modifier) {
    val editing = editor.editing
    val errors = editing.errors.filter { tab == EditTab.CHOSEN && it.thing in editing.selection }
        .map { validationErrorText(editing.world, it) }
    key(tab, if (tab == EditTab.CHOSEN) editor.editing.selection else null) {
        FieldPanel(WorldTags.EDIT_PANEL, errors, WorldTags.CHOSEN_TROUBLE, modifier) {
            when (tab) {
                EditTab.CHOSEN -> ChosenPanel(editor)
                EditTab.THINGS -> ElementsPanel(editor) { onTab(EditTab.CHOSEN) }
                EditTab.GOALS -> GoalsPanel(editor) { onTab(EditTab.CHOSEN) }
                EditTab.WORLD -> WorldPanel(editor)
            }
        }
    }
}
