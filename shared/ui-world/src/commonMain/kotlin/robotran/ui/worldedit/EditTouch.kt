package robotran.ui.worldedit

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.isShiftPressed
import robotran.ui.editing.FINGER_REACH
import robotran.ui.editing.HANDLE_REACH
import robotran.ui.editing.TouchEnd
import robotran.ui.editing.drag
import robotran.ui.editing.moves
import robotran.ui.editing.push
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.worldediting.DragHandle
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.elementsAt

/** Follows one finger on the sheet from press to release. [latest] returns the current world. */
internal suspend fun AwaitPointerEventScope.editByFinger(view: EditView, latest: () -> EditorScope, down: Offset) =
    with(SheetFinger(view, latest(), density, latest)) { follow(down, currentEvent.keyboardModifiers.isShiftPressed) }

private class SheetFinger(
    private val view: EditView,
    private val editor: EditorScope,
    private val density: Float,
    private val latest: () -> EditorScope,
) {
    private val transform = view.transform
    private val reach = transform.toCentimetres(FINGER_REACH * density)

    suspend fun AwaitPointerEventScope.follow(down: Offset, adding: Boolean) {
        val at = centimetres(down)
        val handle = handleAt(positionedHandles(editor.editing, transform, density), down, HANDLE_REACH * density)
        val there = editor.world.elementsAt(at, reach)
        val isAdding = adding || editor.editing.isMultiSelect
        when {
            editor.editing.tool != Tool.SELECT -> draw(down)
            handle != null -> dragOrTap(down, adding) { take(handle, at) }
            there.any { it in editor.editing.selection } -> dragOrTap(down, adding) { take(DragHandle.Body, at) }

            there.isNotEmpty() && !isAdding -> dragOrTap(down, adding = false) {
                editor.make(WorldEdit.Select(there.first()))
                take(DragHandle.Body, at)
            }

            isAdding -> box(down, adding)
            push(view, down) -> editor.make(WorldEdit.TapAt(at, reach))
        }
    }

    private fun take(grip: DragHandle, at: Point) = editor.make(WorldEdit.StartDrag(grip, at))

    private suspend fun AwaitPointerEventScope.dragOrTap(down: Offset, adding: Boolean, take: () -> Unit) {
        val isTap = drag(view, down, latest, take) { WorldEdit.DragTo(centimetres(it), reach / 2) }
        if (isTap) editor.make(WorldEdit.TapAt(centimetres(down), reach, adding))
    }

    private suspend fun AwaitPointerEventScope.box(down: Offset, adding: Boolean) {
        val end = moves(view, down) { place ->
            view.box =
                Rect(minOf(down.x, place.x), minOf(down.y, place.y), maxOf(down.x, place.x), maxOf(down.y, place.y))
        }
        val box = view.box
        view.box = null
        if (end != TouchEnd.UP) return
        if (box == null) return editor.make(WorldEdit.TapAt(centimetres(down), reach, adding))
        val low = centimetres(box.bottomLeft)
        val high = centimetres(box.topRight)
        editor.make(WorldEdit.SelectWithin(Bounds(low.x, low.y, high.x, high.y), adding = true))
    }

    private suspend fun AwaitPointerEventScope.draw(down: Offset) {
        view.line = listOf(down)
        val end = moves(view, down) { place -> view.line += place }
        val line = view.line
        view.line = emptyList()
        if (end == TouchEnd.UP) editor.make(WorldEdit.Draw(line.map(::centimetres)))
    }

    private fun centimetres(position: Offset): Point = transform.toCentimetres(position)
}
