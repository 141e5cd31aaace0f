package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import robotran.editing.WorldEditorTexts
import robotran.ui.editing.EditorHints
import robotran.ui.editing.HintAction
import robotran.ui.editing.MAX_HINTS
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.WorldEditState
import robotran.worldediting.WorldEdit

/** Why an edit was rejected, or the world's errors. */
@Composable
internal fun EditHints(state: WorldEditState, editor: EditorScope, modifier: Modifier = Modifier) {
    val editing = state.editing
    val sentences = listOfNotNull(
        editing.error?.let { editErrorText(it) },
        WorldEditorTexts.mendFirst(spoken).takeIf { state.hasFailedToClose },
    ) + editing.errors.take(MAX_HINTS).map { validationErrorText(editing.world, it) }
    if (sentences.isEmpty() || !state.hintsShown) return
    val thing = editing.errors.firstOrNull()?.thing?.takeIf { it !in editing.selection }
    EditorHints(
        WorldTags.EDIT_HINTS,
        sentences,
        LocalRobotranColours.current.errorPane,
        thing?.let { HintAction(WorldTags.SHOW_TROUBLE) { editor.make(WorldEdit.Select(it)) } },
        { editor.perform(WorldEditEvent.HintsClosed) },
        modifier,
    )
}
