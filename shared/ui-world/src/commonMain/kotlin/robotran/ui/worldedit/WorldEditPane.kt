package robotran.ui.worldedit

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.heightIn
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberUpdatedState
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.unit.dp
import robotran.simulation.state.SessionState
import robotran.ui.common.AutosaveBanner
import robotran.ui.editing.EditorFrame
import robotran.ui.editing.EditorParts
import robotran.ui.editing.editForCommand
import robotran.ui.world.tags.WorldTags
import robotran.ui.world.texts.SheetTexts
import robotran.uikit.*
import robotran.workshop.event.WorkshopEvent
import robotran.workshop.state.DocumentState
import robotran.workshop.state.WorldEditState
import robotran.worldediting.ElementKind
import robotran.worldediting.WorldEditing

/** The world editor, which replaces the workshop: palette, sheet, and properties of the elements. */
@Composable
fun WorldEditPane(
    state: WorldEditState,
    session: SessionState,
    document: DocumentState,
    onEvent: (WorkshopEvent) -> Unit,
    modifier: Modifier = Modifier,
) {
    val editor = EditorScope(state.editing, onEvent)
    val latest = rememberUpdatedState(editor)
    val view = remember { EditView { latest.value.world.paper } }
    val focus = remember { FocusRequester() }
    val parts = EditorParts(
        EditTab.entries,
        tabWidth = 72.dp,
        columns = 2,
        chosen = state.editing.selection,
        tabFor = { open -> tabFor(state.editing, open) },
        canvas = {
            BoxWithConstraints(it) {
                EditSheet(editor, view, session, focus)
                val over = Modifier.padding(8.dp).heightIn(max = maxHeight / 2)
                EditHints(state, editor, Modifier.align(Alignment.TopCenter).then(over))
                AutosaveBanner(document, onEvent, Modifier.align(Alignment.BottomCenter).then(over))
            }
        },
        palette = { columns, place -> PaletteStrip(editor, view, columns, { focus.requestFocus() }, place) },
        panel = { tab, onTab, place -> EditPanel(editor, tab, onTab, place) },
    )
    EditorFrame(
        WorldTags.WORLD_EDIT,
        SheetTexts.editWorld(spoken),
        parts,
        view.carried,
        onCommand = { event -> editForCommand(event)?.let(editor::make) != null },
        modifier,
    ) { withWords ->
        EditBar(editor, view, withWords, canTry = state.origin?.variation == null)
        state.origin?.let { AssignmentBanner(it, onEvent) }
    }
}

/** The tab that shows what is selected; a goal selected in the list of goals stays there. */
private fun tabFor(editing: WorldEditing, open: EditTab?): EditTab? {
    val stays = open == EditTab.GOALS && editing.selection.all { it.kind == ElementKind.GOAL }
    val picksSeveral = open == EditTab.THINGS && editing.isMultiSelect
    return EditTab.CHOSEN.takeIf { editing.selection.isNotEmpty() && !stays && !picksSeveral }
}
