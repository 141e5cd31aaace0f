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
        "edit",
        editor,
        editing.history,
        withWords,
        onDone = { editor.perform(WorldEditEvent.EditorClosed) },
        beforeDone = { if (canTry) TryButton(editor, withWords) },
    ) {
        val several = WorldEditorTexts.several(spoken)
        BarToggle(EditIcons.SEVERAL, several, "edit-several", editing.isMultiSelect, withWords) {
            editor.make(WorldEdit.SetMultiSelect(!editing.isMultiSelect))
        }
        EditMenu(editor, view, withWords)
    }
}

@Composable
private fun TryButton(editor: EditorScope, withWords: Boolean) = IconButton(
    EditIcons.PLAY,
    WorldEditorTexts.tryHelp(spoken),
    "edit-try",
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
        BarTool(Icon.MORE, WorldEditorTexts.moreMenu(spoken), "edit-menu", withWords) { open = true }
        AppMenu(open, { open = false }, Modifier.widthIn(min = 260.dp)) {
            MenuItem(WorldEditorTexts.chooseAll(spoken), "menu-all") {
                choose { editor.make(WorldEdit.SelectAll) }
            }
            MenuItem(WorldEditorTexts.copy(spoken), "menu-copy") { choose { editor.make(WorldEdit.Copy) } }
            MenuItem(WorldEditorTexts.paste(spoken), "menu-paste") {
                choose { editor.make(WorldEdit.Paste(view.middle)) }
            }
            MenuItem(WorldEditorTexts.wholeSheet(spoken), "menu-fit") {
                choose { view.camera = SheetCamera.FITTING }
            }
            MenuItem(WorldEditorTexts.zoomIn(spoken), "menu-zoom-in") {
                choose { view.zoomBy(ZOOM, view.pane.center) }
            }
            MenuItem(WorldEditorTexts.zoomOut(spoken), "menu-zoom-out") {
                choose { view.zoomBy(1 / ZOOM, view.pane.center) }
            }
            MenuDivider()
            for (grid in GRIDS) {
                val words = if (grid > 0) {
                    WorldEditorTexts.grid(spoken, written(grid))
                } else {
                    WorldEditorTexts.gridOff(spoken)
                }
                MenuItem(checked(words, snapping.grid == grid), "menu-grid-${written(grid)}") {
                    choose { editor.make(WorldEdit.Snap(snapping.copy(grid = grid))) }
                }
            }
            MenuItem(checked(WorldEditorTexts.snapAngle(spoken), snapping.angle > 0), "menu-angle") {
                val angle = if (snapping.angle > 0) 0.0 else Snapping().angle
                choose { editor.make(WorldEdit.Snap(snapping.copy(angle = angle))) }
            }
            MenuItem(checked(WorldEditorTexts.snapOthers(spoken), snapping.toOthers), "menu-others") {
                choose { editor.make(WorldEdit.Snap(snapping.copy(toOthers = !snapping.toOthers))) }
            }
            MenuDivider()
            MenuItem(WorldEditorTexts.discard(spoken), "menu-discard") {
                choose { editor.perform(WorldEditEvent.EditsDiscarded) }
            }
        }
    }
}

private fun checked(label: String, on: Boolean) = if (on) "✓ $label" else "   $label"

private val GRIDS = listOf(1.0, 0.5, 0.0)
private const val ZOOM = 1.5
