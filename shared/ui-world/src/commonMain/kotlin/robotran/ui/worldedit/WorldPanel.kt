package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.editing.WorldEditorTexts
import robotran.editing.making
import robotran.ui.editing.Form
import robotran.ui.editing.HelpText
import robotran.ui.editing.RowHeading
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.worldediting.WorldEdit
import robotran.worldediting.fieldsOf
import robotran.worldediting.parameters

/** All properties of the world as a whole. */
@Composable
internal fun WorldPanel(editor: EditorScope) {
    Form(fieldsOf(editor.world.parameters).making { WorldEdit.ChangeSheet(it) }, editor)
    val newTitle = WorldEditorTexts.newTitle(spoken)
    RowHeading(WorldEditorTexts.startOver(spoken))
    Button(WorldEditorTexts.newWorld(spoken), WorldTags.NEW_WORLD, ButtonKind.EDITOR) {
        editor.makeAtOnce(WorldEdit.NewWorld(newTitle))
    }
    HelpText(WorldEditorTexts.newWorldHelp(spoken))
}
