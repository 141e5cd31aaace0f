package robotran.ui.program.blocks

import androidx.compose.foundation.lazy.LazyListItemInfo
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.ui.geometry.Offset
import robotran.blockediting.BlockPlace
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.DragPayload
import robotran.workshop.blocks.blocksIn
import robotran.workshop.blocks.placeAbove
import robotran.workshop.blocks.placeBelow

/**
 * Where carried blocks land.
 *
 * @property row the index of the row beside it.
 * @property isBelow whether it is below that row, not above.
 * @property depth the number of blocks around it.
 */
internal data class Landing(val place: BlockPlace, val row: Int, val isBelow: Boolean, val depth: Int)

/** Where [load] lands at [position] of the list [rows], in pixels; null if it cannot. */
internal fun landingAt(position: Offset, rows: LazyListState, state: BlocksState, load: DragPayload?): Landing? {
    val item = rows.itemAt(position) ?: return landingAtEnd(state)
    val row = state.list.rows.getOrNull(item.index) ?: return landingAtEnd(state)
    val isBelow = position.y > item.offset + item.size / 2
    val place = (if (isBelow) row.placeBelow(state.program) else row.placeAbove(state.program)) ?: return null
    if (isInside(load, place, state)) return null
    val depth = place.parent?.let { state.program[it] }?.let { it.head.depth + 1 } ?: 0
    return Landing(place, item.index, isBelow, depth)
}

internal fun LazyListState.itemAt(position: Offset): LazyListItemInfo? =
    layoutInfo.visibleItemsInfo.firstOrNull { position.y >= it.offset && position.y < it.offset + it.size }

/** Blocks cannot land in themselves. */
private fun isInside(load: DragPayload?, place: BlockPlace, state: BlocksState): Boolean {
    val carried = (load as? DragPayload.Blocks)?.let { state.program.blocksIn(it.run) }.orEmpty().map { it.id }
    return generateSequence(place.parent) { state.program.placeOf(it)?.parent }.any { it in carried }
}

private fun landingAtEnd(state: BlocksState): Landing? =
    state.program.endOf(null)?.let { Landing(it, state.list.rows.lastIndex, isBelow = true, depth = 0) }
