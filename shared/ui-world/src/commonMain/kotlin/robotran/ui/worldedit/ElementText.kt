package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import robotran.editing.WorldEditorTexts
import robotran.uikit.*
import robotran.world.World
import robotran.worldediting.ElementRef
import robotran.worldediting.WorldEditing
import robotran.worldediting.elementWords

/** The display name of [ref], such as `wall 3, 40 cm`. */
@Composable
internal fun elementText(world: World, ref: ElementRef): String = elementWords(world, ref)(spoken)

/** The selection in words. */
@Composable
internal fun selectionText(editing: WorldEditing): String {
    val only = editing.only
    return when {
        only != null -> WorldEditorTexts.oneChosen(spoken, elementText(editing.world, only))
        editing.selection.isEmpty() -> WorldEditorTexts.noneChosen(spoken)
        else -> WorldEditorTexts.severalChosen(spoken, editing.selection.size)
    }
}
