package robotran.ui.worldedit

import androidx.compose.foundation.gestures.awaitEachGesture
import androidx.compose.foundation.gestures.awaitFirstDown
import androidx.compose.foundation.gestures.calculateCentroid
import androidx.compose.foundation.gestures.calculatePan
import androidx.compose.foundation.gestures.calculateZoom
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputScope
import androidx.compose.ui.input.pointer.changedToUp
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.positionChanged
import robotran.world.geometry.Bounds
import robotran.world.geometry.Point
import robotran.worldediting.DragHandle
import robotran.worldediting.Tool
import robotran.worldediting.WorldEdit
import robotran.worldediting.elementsAt

/** Handles touch and mouse input on the sheet. [making] returns the current world. */
internal suspend fun PointerInputScope.editByTouch(view: EditView, making: () -> EditorScope, onTouched: () -> Unit) =
    awaitEachGesture {
        val down = awaitFirstDown()
        onTouched()
        val finger = SheetFinger(view, making(), density, making)
        with(finger) { follow(down.position, currentEvent.keyboardModifiers.isShiftPressed) }
    }

/** The mouse wheel zooms at the pointer. */
internal suspend fun PointerInputScope.zoomByWheel(view: EditView, making: () -> EditorScope) = awaitPointerEventScope {
    while (true) {
        val event = awaitPointerEvent()
        if (event.type != PointerEventType.Scroll) continue
        val change = event.changes.first()
        view.zoomBy(if (change.scrollDelta.y < 0) WHEEL_ZOOM else 1 / WHEEL_ZOOM, change.position, making().world.paper)
        change.consume()
    }
}

/** One finger from press to release. */
private class SheetFinger(
    private val view: EditView,
    private val editor: EditorScope,
    private val density: Float,
    private val latest: () -> EditorScope,
) {
    private val transform = view.transform(editor.world.paper)
    private val reach = transform.toCentimetres(FINGER * density)

    suspend fun AwaitPointerEventScope.follow(down: Offset, adding: Boolean) {
        val handles = positionedHandles(editor.editing, transform, density)
        val handle = handleAt(handles, down, HANDLE * density)
        val there = editor.world.elementsAt(centimetres(down), reach)
        when {
            editor.editing.tool != Tool.SELECT -> draw(down)
            handle != null -> drag(down, adding) {
                editor.make(WorldEdit.StartDrag(handle.handle.grip, centimetres(down)))
            }

            there.any {
                it in editor.editing.selection
            } -> drag(down, adding) { editor.make(WorldEdit.StartDrag(DragHandle.Body, centimetres(down))) }
            there.isNotEmpty() && !adding && !editor.editing.isMultiSelect -> drag(down, adding = false) {
                takeNew(down)
            }
            adding || editor.editing.isMultiSelect -> box(down, adding)
            else -> push(down)
        }
    }

    private fun takeNew(down: Offset) {
        editor.make(WorldEdit.Select(editor.world.elementsAt(centimetres(down), reach).first()))
        editor.make(WorldEdit.StartDrag(DragHandle.Body, centimetres(down)))
    }

    private suspend fun AwaitPointerEventScope.drag(down: Offset, adding: Boolean, take: () -> Unit) {
        var held = false
        val end = moves(down) { place ->
            if (!held) take()
            held = true
            latest().make(WorldEdit.DragTo(centimetres(place), reach / 2))
        }
        when {
            end == End.SECOND_FINGER && held -> latest().make(WorldEdit.CancelDrag)
            held -> latest().make(WorldEdit.Drop)
            end == End.UP -> editor.make(WorldEdit.TapAt(centimetres(down), reach, adding))
        }
    }

    private suspend fun AwaitPointerEventScope.push(down: Offset) {
        var last = down
        var moved = false
        val end = moves(down) { place ->
            moved = true
            view.pushBy(place - last, editor.world.paper)
            last = place
        }
        if (!moved && end == End.UP) editor.make(WorldEdit.TapAt(centimetres(down), reach))
    }

    private suspend fun AwaitPointerEventScope.box(down: Offset, adding: Boolean) {
        val end = moves(down) { place ->
            view.box =
                Rect(minOf(down.x, place.x), minOf(down.y, place.y), maxOf(down.x, place.x), maxOf(down.y, place.y))
        }
        val box = view.box
        view.box = null
        if (end != End.UP) return
        if (box == null) return editor.make(WorldEdit.TapAt(centimetres(down), reach, adding))
        val low = centimetres(box.bottomLeft)
        val high = centimetres(box.topRight)
        editor.make(WorldEdit.SelectWithin(Bounds(low.x, low.y, high.x, high.y), adding = true))
    }

    private suspend fun AwaitPointerEventScope.draw(down: Offset) {
        view.line = listOf(down)
        val end = moves(down) { place -> view.line += place }
        val line = view.line
        view.line = emptyList()
        if (end == End.UP) editor.make(WorldEdit.Draw(line.map(::centimetres)))
    }

    private enum class End { UP, SECOND_FINGER }

    /** Passes positions to [onMove] once the finger has moved. A second finger starts a pinch and cancels all else. */
    private suspend fun AwaitPointerEventScope.moves(down: Offset, onMove: (Offset) -> Unit): End {
        var moving = false
        while (true) {
            val event = awaitPointerEvent()
            if (event.changes.count { it.pressed } > 1) {
                pinch()
                return End.SECOND_FINGER
            }
            val change = event.changes.first()
            if (change.changedToUp() || !change.pressed) {
                change.consume()
                return End.UP
            }
            if (!change.positionChanged()) continue
            moving = moving || (change.position - down).getDistance() > viewConfiguration.touchSlop
            if (moving) onMove(change.position)
            change.consume()
        }
    }

    private suspend fun AwaitPointerEventScope.pinch() {
        while (true) {
            val event = awaitPointerEvent()
            if (event.changes.none { it.pressed }) return
            val paper = editor.world.paper
            if (event.changes.count { it.pressed } > 1) {
                view.pushBy(event.calculatePan(), paper)
                view.zoomBy(event.calculateZoom().toDouble(), event.calculateCentroid(), paper)
            }
            event.changes.forEach { it.consume() }
        }
    }

    private fun centimetres(position: Offset): Point = transform.toCentimetres(position)
}

private const val WHEEL_ZOOM = 1.2

/** The tolerance of a finger for elements and for handles, in dp. */
private const val FINGER = 12f
private const val HANDLE = 24f
