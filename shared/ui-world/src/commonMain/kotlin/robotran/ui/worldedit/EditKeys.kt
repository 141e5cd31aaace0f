package robotran.ui.worldedit

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.input.key.KeyEvent
import androidx.compose.ui.input.key.KeyEventType
import androidx.compose.ui.input.key.isCtrlPressed
import androidx.compose.ui.input.key.isMetaPressed
import androidx.compose.ui.input.key.isShiftPressed
import androidx.compose.ui.input.key.key
import androidx.compose.ui.input.key.type
import robotran.ui.editing.FINE_STEP
import robotran.ui.editing.editForCommand
import robotran.uikit.*
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.WorldEditing
import robotran.worldediting.listed
import robotran.worldediting.turnStep

/** The edit for a key on the sheet; null for none. */
internal fun editForKey(event: KeyEvent, editing: WorldEditing): WorldEdit? {
    if (event.type != KeyEventType.KeyDown) return null
    if (event.isCtrlPressed || event.isMetaPressed) return editForCommand(event)
    val shift = event.isShiftPressed
    return when (event.key) {
        Key.Tab -> tabbed(editing, shift)
        Key.DirectionLeft -> nudge(editing, -1, 0, shift)
        Key.DirectionRight -> nudge(editing, 1, 0, shift)
        Key.DirectionUp -> nudge(editing, 0, 1, shift)
        Key.DirectionDown -> nudge(editing, 0, -1, shift)
        Key.R -> WorldEdit.TurnBy(editing.turnStep * if (shift) -1 else 1)
        Key.Plus, Key.Equals, Key.NumPadAdd -> WorldEdit.ScaleBy(GROWTH)
        Key.Minus, Key.NumPadSubtract -> WorldEdit.ScaleBy(1 / GROWTH)
        Key.Delete, Key.Backspace -> WorldEdit.Delete
        Key.G -> if (shift) WorldEdit.Ungroup else WorldEdit.Group
        Key.Escape -> escaped(editing)
        else -> null
    }
}

/** The edit for Ctrl and a key, if the focused element has not consumed it. */
internal fun editForCommand(event: KeyEvent): WorldEdit? = editForCommand(event, WorldEdit.COMMON) { key ->
    when (key) {
        Key.C -> WorldEdit.Copy
        Key.V -> WorldEdit.Paste()
        Key.D -> WorldEdit.Duplicate
        Key.A -> WorldEdit.SelectAll
        Key.G -> if (event.isShiftPressed) WorldEdit.Ungroup else WorldEdit.Group
        else -> null
    }
}

/** After the last element the focus moves on from the sheet. */
private fun tabbed(editing: WorldEditing, backwards: Boolean): WorldEdit? {
    val listed = editing.world.listed()
    val end = if (backwards) listed.first() else listed.last()
    val isAtEnd = end in editing.selection || (backwards && editing.selection.isEmpty())
    return if (isAtEnd) null else WorldEdit.SelectNext(backwards)
}

private fun nudge(editing: WorldEditing, x: Int, y: Int, fine: Boolean): WorldEdit {
    val step = if (fine) FINE_STEP else editing.snapping.grid.takeIf { it > 0 } ?: 1.0
    return WorldEdit.Nudge(x * step, y * step)
}

/** The edit for Escape and Back in the editor, one step at a time; null if they close it. */
fun escaped(editing: WorldEditing): WorldEdit? = when {
    editing.gesture != null -> WorldEdit.CancelDrag
    editing.tool != Tool.SELECT -> WorldEdit.SelectTool(Tool.SELECT)
    editing.selection.isNotEmpty() -> WorldEdit.Select(null)
    else -> null
}

internal const val GROWTH = 1.1
