package robotran.ui.worldedit

import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.widthIn
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.editing.WorldEditorTexts
import robotran.editing.written
import robotran.ui.editing.BarToggle
import robotran.ui.editing.BarTool
import robotran.ui.editing.EditorBar
import robotran.ui.world.tags.WorldTags
import robotran.uikit.*
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.SheetCamera
import robotran.worldediting.Snapping
import robotran.worldediting.WorldEdit

/**
 * The top of the world editor.
 *
 * @param canTry whether robots can drive in this world; false in a variation of an assignment.
 */
@Composable
internal fun EditBar(editor: EditorScope, view: EditView, withWords: Boolean, canTry: Boolean) {
    val editing = editor.editing
    EditorBar(
        WorldTags.EDIT,
        editor,
        editing.history,
        withWords,
        onDone = { editor.perform(WorldEditEvent.EditorClosed) },
        beforeDone = { if (canTry) TryButton(editor, withWords) },
    ) {
        val several = WorldEditorTexts.several(spoken)
        BarToggle(EditIcons.SEVERAL, several, WorldTags.EDIT_SEVERAL, editing.isMultiSelect, withWords) {
            editor.make(WorldEdit.SetMultiSelect(!editing.isMultiSelect))
        }
        EditMenu(editor, view, withWords)
    }
}

@Composable
private fun TryButton(editor: EditorScope, withWords: Boolean) = IconButton(
    EditIcons.PLAY,
    WorldEditorTexts.tryHelp(spoken),
    WorldTags.EDIT_TRY,
    label = WorldEditorTexts.worldeditTry(spoken).takeIf { withWords },
) { editor.perform(WorldEditEvent.TriedOut) }

/** Rare actions. */
@Composable
private fun EditMenu(editor: EditorScope, view: EditView, withWords: Boolean) {
    var open by remember { mutableStateOf(false) }
    val choose = { action: () -> Unit ->
        open = false
        action()
    }
    val snapping = editor.editing.snapping
    Box {
        BarTool(Icon.MORE, WorldEditorTexts.moreMenu(spoken), WorldTags.EDIT_MENU, withWords) { open = true }
        AppMenu(open, { open = false }, Modifier.widthIn(min = 260.dp)) {
            MenuItem(WorldEditorTexts.chooseAll(spoken), WorldTags.MENU_ALL) {
                choose { editor.make(WorldEdit.SelectAll) }
            }
            MenuItem(WorldEditorTexts.copy(spoken), WorldTags.MENU_COPY) { choose { editor.make(WorldEdit.Copy) } }
            MenuItem(WorldEditorTexts.paste(spoken), WorldTags.MENU_PASTE) {
                choose { editor.make(WorldEdit.Paste(view.middle)) }
            }
            MenuItem(WorldEditorTexts.wholeSheet(spoken), WorldTags.MENU_FIT) {
                choose { view.camera = SheetCamera.FITTING }
            }
            MenuItem(WorldEditorTexts.zoomIn(spoken), WorldTags.MENU_ZOOM_IN) {
                choose { view.zoomBy(ZOOM, view.pane.center) }
            }
            MenuItem(WorldEditorTexts.zoomOut(spoken), WorldTags.MENU_ZOOM_OUT) {
                choose { view.zoomBy(1 / ZOOM, view.pane.center) }
            }
            MenuDivider()
            for (grid in GRIDS) {
                val words = if (grid > 0) {
                    WorldEditorTexts.grid(spoken, written(grid))
                } else {
                    WorldEditorTexts.gridOff(spoken)
                }
                MenuItem(checked(words, snapping.grid == grid), WorldTags.menuGrid(written(grid))) {
                    choose { editor.make(WorldEdit.Snap(snapping.copy(grid = grid))) }
                }
            }
            MenuItem(checked(WorldEditorTexts.snapAngle(spoken), snapping.angle > 0), WorldTags.MENU_ANGLE) {
                val angle = if (snapping.angle > 0) 0.0 else Snapping().angle
                choose { editor.make(WorldEdit.Snap(snapping.copy(angle = angle))) }
            }
            MenuItem(checked(WorldEditorTexts.snapOthers(spoken), snapping.toOthers), WorldTags.MENU_OTHERS) {
                choose { editor.make(WorldEdit.Snap(snapping.copy(toOthers = !snapping.toOthers))) }
            }
            MenuDivider()
            MenuItem(WorldEditorTexts.discard(spoken), WorldTags.MENU_DISCARD) {
                choose { editor.perform(WorldEditEvent.EditsDiscarded) }
            }
        }
    }
}

private fun checked(label: String, on: Boolean) = if (on) "✓ $label" else "   $label"

private val GRIDS = listOf(1.0, 0.5, 0.0)
private const val ZOOM = 1.5
