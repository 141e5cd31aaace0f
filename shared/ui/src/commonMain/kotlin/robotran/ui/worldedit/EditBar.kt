package robotran.ui.worldedit

import androidx.compose.foundation.background
import androidx.compose.foundation.horizontalScroll
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.widthIn
import androidx.compose.foundation.rememberScrollState
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.alpha
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.disabled
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.semantics.toggleableState
import androidx.compose.ui.state.ToggleableState
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import robotran.ui.texts.WorldEditorTexts
import robotran.uikit.*
import robotran.workshop.event.WorldEditEvent
import robotran.workshop.state.SheetCamera
import robotran.worldediting.Snapping
import robotran.worldediting.WorldEdit
import robotran.worldediting.written

/**
 * The top of the editor: undo, help, and the button that closes it.
 *
 * @param canTry whether robots can drive in this world; false in a variation of an assignment.
 */
@Composable
internal fun EditBar(editor: EditorScope, view: EditView, withWords: Boolean, canTry: Boolean) {
    val colours = LocalRobotranColours.current
    val editing = editor.editing
    Row(
        Modifier.fillMaxWidth().background(colours.pane).padding(4.dp),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Row(
            Modifier.weight(1f).horizontalScroll(rememberScrollState()),
            verticalAlignment = Alignment.CenterVertically,
        ) {
            Step(
                EditIcons.UNDO,
                WorldEditorTexts.undo(spoken),
                "edit-undo",
                editing.history.canUndo,
                withWords,
            ) {
                editor.make(WorldEdit.Undo)
            }
            Step(
                EditIcons.REDO,
                WorldEditorTexts.redo(spoken),
                "edit-redo",
                editing.history.canRedo,
                withWords,
            ) {
                editor.make(WorldEdit.Redo)
            }
            Toggle(
                EditIcons.SEVERAL,
                WorldEditorTexts.several(spoken),
                "edit-several",
                editing.isMultiSelect,
                withWords,
            ) {
                editor.make(WorldEdit.SetMultiSelect(!editing.isMultiSelect))
            }
            EditMenu(editor, view, withWords)
        }
        if (canTry) {
            IconButton(
                EditIcons.PLAY,
                WorldEditorTexts.tryHelp(spoken),
                "edit-try",
                label = WorldEditorTexts.worldeditTry(spoken).takeIf { withWords },
            ) {
                editor.perform(WorldEditEvent.TriedOut)
            }
        }
        Button(
            WorldEditorTexts.done(spoken),
            "edit-done",
            ButtonKind.EDITOR_BAR,
            Modifier.padding(start = 4.dp),
            style = TextStyles.body.strong,
        ) { editor.perform(WorldEditEvent.EditorClosed) }
    }
}

@Composable
private fun Step(icon: Icon, words: String, tag: String, enabled: Boolean, withWords: Boolean, onClick: () -> Unit) =
    IconButton(
        icon,
        words,
        tag,
        modifier = Modifier.alpha(if (enabled) 1f else FAINT).semantics { if (!enabled) disabled() },
        label = words.takeIf { withWords },
    ) { if (enabled) onClick() }

@Composable
private fun Toggle(icon: Icon, words: String, tag: String, on: Boolean, withWords: Boolean, onClick: () -> Unit) =
    IconButton(
        icon,
        words,
        tag,
        modifier = Modifier
            .semantics { toggleableState = if (on) ToggleableState.On else ToggleableState.Off }
            .background(
                if (on) LocalRobotranColours.current.runningLine else LocalRobotranColours.current.pane,
                Shapes.MEDIUM,
            ),
        label = words.takeIf { withWords },
        onClick = onClick,
    )

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
        IconButton(
            Icon.MORE,
            WorldEditorTexts.moreMenu(spoken),
            "edit-menu",
            label = WorldEditorTexts.moreMenu(spoken).takeIf { withWords },
        ) { open = true }
        AppMenu(open, { open = false }, Modifier.widthIn(min = 260.dp)) {
            MenuItem(WorldEditorTexts.chooseAll(spoken), "menu-all") {
                choose { editor.make(WorldEdit.SelectAll) }
            }
            MenuItem(WorldEditorTexts.copy(spoken), "menu-copy") { choose { editor.make(WorldEdit.Copy) } }
            MenuItem(WorldEditorTexts.paste(spoken), "menu-paste") {
                choose { editor.make(WorldEdit.Paste(view.middle(editor.world.paper))) }
            }
            MenuItem(WorldEditorTexts.wholeSheet(spoken), "menu-fit") {
                choose {
                    view.camera = SheetCamera.FITTING
                }
            }
            MenuItem(WorldEditorTexts.zoomIn(spoken), "menu-zoom-in") {
                choose { view.zoomBy(ZOOM, view.pane.center, editor.world.paper) }
            }
            MenuItem(WorldEditorTexts.zoomOut(spoken), "menu-zoom-out") {
                choose { view.zoomBy(1 / ZOOM, view.pane.center, editor.world.paper) }
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
                choose {
                    editor.make(
                        WorldEdit.Snap(
                            snapping.copy(
                                angle = if (snapping.angle > 0) {
                                    0.0
                                } else {
                                    Snapping().angle
                                },
                            ),
                        ),
                    )
                }
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
private const val FAINT = 0.38f
