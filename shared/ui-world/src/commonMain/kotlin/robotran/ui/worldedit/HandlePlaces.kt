package robotran.ui.worldedit

import androidx.compose.ui.geometry.Offset
import robotran.ui.editing.HandleAt
import robotran.ui.editing.nearest
import robotran.ui.sheet.SheetTransform
import robotran.uikit.*
import robotran.worldediting.DragHandle
import robotran.worldediting.Handle
import robotran.worldediting.WorldEditing
import robotran.worldediting.frameOf
import robotran.worldediting.handlesOf

/** The handles of the selection that are far enough apart for a finger; [density] is pixels per dp. */
internal fun positionedHandles(
    editing: WorldEditing,
    transform: SheetTransform,
    density: Float,
): List<HandleAt<DragHandle>> {
    val frame = editing.world.frameOf(editing.selection) ?: return emptyList()
    val wide = transform.toPixels(frame.width) / density
    val high = transform.toPixels(frame.height) / density
    return editing.world.handlesOf(editing.selection).filter { handle ->
        when (val grip = handle.grip) {
            is DragHandle.Size -> if (grip.side.isCorner) true else hasRoom(grip, wide, high)
            is DragHandle.Edge -> edgeHasRoom(editing, handle, transform, density)
            else -> true
        }
    }.map { handle ->
        val away = if (handle.grip == DragHandle.Turn) TURN_DISTANCE else SIZE_DISTANCE
        val place = transform.toPixels(handle.place)
        HandleAt(
            handle.grip,
            place + Offset(handle.outwards.x.toFloat(), -handle.outwards.y.toFloat()) * (away * density),
        )
    }
}

/** The handle within [reach] of [position]; turn and corner handles have priority over edge handles. */
internal fun handleAt(handles: List<HandleAt<DragHandle>>, position: Offset, reach: Float): DragHandle? =
    handles.nearest(position, reach) { if (it is DragHandle.Edge) reach / 2 else 0f }

private fun hasRoom(grip: DragHandle.Size, wide: Float, high: Float) =
    (grip.side.across == 0 && wide >= ROOM_FOR_MIDDLE) || (grip.side.up == 0 && high >= ROOM_FOR_MIDDLE)

/** Close corners leave no room for handles between them. */
private fun edgeHasRoom(editing: WorldEditing, handle: Handle, transform: SheetTransform, density: Float): Boolean {
    val nearest = editing.world.handlesOf(editing.selection).filter { it.grip is DragHandle.Corner }.minOfOrNull {
        (transform.toPixels(it.place) - transform.toPixels(handle.place)).getDistance()
    }
    return nearest != null && nearest >= ROOM_FOR_EDGE * density
}

/** All in dp. */
private const val SIZE_DISTANCE = 12f
private const val TURN_DISTANCE = 40f
private const val ROOM_FOR_MIDDLE = 72f
private const val ROOM_FOR_EDGE = 28f
