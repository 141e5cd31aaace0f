package robotran.ui.worldedit

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.text.rememberTextMeasurer
import robotran.editing.WorldEditorTexts
import robotran.simulation.state.SessionState
import robotran.ui.editing.CanvasWords
import robotran.ui.editing.EditorCanvas
import robotran.ui.sheet.SheetColours
import robotran.ui.sheet.SheetZoom
import robotran.ui.sheet.drawSheet
import robotran.ui.sheet.drawSights
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.state.SheetLayer
import robotran.worldediting.ElementKind

/** The sheet of the world editor, with touch and keyboard input. Screen readers announce the selection. */
@Composable
internal fun EditSheet(editor: EditorScope, view: EditView, session: SessionState, focus: FocusRequester) {
    val colours = LocalRobotranColours.current
    val sheetColours = remember(colours) { SheetColours.of(colours) }
    val world = editor.world
    val zoom = remember(world) { SheetZoom(world) }
    val resting = remember(world, session.brick) { initialStateOf(world, session) }
    val labels = rememberTextMeasurer()
    val shown = if (editor.editing.snapping.grid > 0) setOf(SheetLayer.GOALS, SheetLayer.GRID) else SheetLayer.DEFAULT
    val isRobotChosen = editor.editing.selection.any { it.kind == ElementKind.ROBOT }
    val words = CanvasWords(WorldTags.EDIT_SHEET, WorldEditorTexts.sheet(spoken), selectionText(editor.editing), false)
    EditorCanvas(
        words,
        editor,
        view,
        focus,
        onKey = { editForKey(it, editor.editing) },
        follow = { latest, down -> editByFinger(view, latest, down) },
    ) {
        val transform = view.transform
        drawSheet(
            zoom.at(transform.pixelsPerCentimetre, settled = true),
            resting,
            sheetColours,
            labels,
            shown,
            transform,
        )
        // Whoever puts a robot somewhere wants to know what it sees there.
        if (isRobotChosen) drawSights(world, resting, transform)
        drawEditing(editor.editing, transform, view, colours)
    }
}
