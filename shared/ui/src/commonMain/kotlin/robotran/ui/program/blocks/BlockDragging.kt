package robotran.ui.program.blocks

import androidx.compose.foundation.lazy.LazyListItemInfo
import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.dp
import robotran.blockediting.BlockPlace
import robotran.workshop.blocks.BlockDrag
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.placeAbove
import robotran.workshop.blocks.placeBelow
import robotran.workshop.event.BlockEvent

/**
 * Where carried blocks land.
 *
 * @property row the index of the row beside it.
 * @property isBelow whether it is below that row, not above.
 * @property depth the number of blocks around it.
 */
internal data class Landing(val place: BlockPlace, val row: Int, val isBelow: Boolean, val depth: Int)

/** Carries blocks over the list [rows]. Positions are in pixels from its upper left corner. */
@Stable
internal class BlockDragging(val rows: LazyListState) {
    lateinit var state: BlocksState
    lateinit var density: Density
    lateinit var onEvent: (BlockEvent) -> Unit
    var isRightToLeft = false

    /** Where the finger is; null while nothing is carried. */
    var finger: Offset? by mutableStateOf(null)
        private set
    var landing: Landing? by mutableStateOf(null)
        private set
    private var load: BlockLoad? = null

    /** Whether the block at [position] is carried at once, without a long press. */
    fun isGrip(position: Offset): Boolean = with(density) {
        val row = rowAt(position) as? BlockRow.First ?: return false
        val across = if (isRightToLeft) rows.layoutInfo.viewportSize.width - position.x else position.x
        val start = (BlockSizes.GUTTER + BlockSizes.INDENT * row.around.size).toPx()
        across in start..start + BlockSizes.GRIP.toPx()
    }

    /** Takes up the block at [position]; false if there is none. */
    fun take(position: Offset): Boolean {
        val row = rowAt(position) ?: return false
        if (row is BlockRow.Empty) return false
        load = BlockLoad.Blocks(state.runOf(row.block.id))
        moveTo(position)
        return true
    }

    fun moveTo(position: Offset) {
        val carried = load ?: return
        finger = position
        val next = landingAt(position)
        val isElsewhere = landing == null || next?.place != landing?.place
        if (isElsewhere) onEvent(BlockEvent.Dragged(BlockDrag(carried, next?.place)))
        landing = next
    }

    fun drop() = end(BlockEvent.Dropped)

    fun cancel() = end(BlockEvent.DragCancelled)

    private fun end(event: BlockEvent) {
        if (load == null) return
        load = null
        finger = null
        landing = null
        onEvent(event)
    }

    /** How many pixels the list scrolls in this frame, because the finger is near its upper or lower edge. */
    fun scrollAtEdge(): Float = with(density) {
        val y = finger?.y ?: return 0f
        val edge = EDGE.toPx()
        val height = rows.layoutInfo.viewportSize.height
        val beyond = when {
            y < edge -> y - edge
            y > height - edge -> y - (height - edge)
            else -> 0f
        }
        beyond / edge * SPEED.toPx()
    }

    private fun rowAt(position: Offset): BlockRow? = itemAt(position)?.let { state.list.rows.getOrNull(it.index) }

    private fun itemAt(position: Offset): LazyListItemInfo? =
        rows.layoutInfo.visibleItemsInfo.firstOrNull { position.y >= it.offset && position.y < it.offset + it.size }

    private fun landingAt(position: Offset): Landing? {
        val item = itemAt(position) ?: return landingAtEnd()
        val row = state.list.rows.getOrNull(item.index) ?: return landingAtEnd()
        val isBelow = position.y > item.offset + item.size / 2
        val place = (if (isBelow) row.placeBelow(state.program) else row.placeAbove(state.program)) ?: return null
        val depth = place.parent?.let { state.program[it] }?.let { it.head.depth + 1 } ?: 0
        return Landing(place, item.index, isBelow, depth)
    }

    private fun landingAtEnd(): Landing? =
        state.program.endOf(null)?.let { Landing(it, state.list.rows.lastIndex, isBelow = true, depth = 0) }
}

/** From this distance to its edge on the list scrolls, the faster the nearer the finger is. */
private val EDGE = 56.dp

/** The fastest scrolling, in a frame. */
private val SPEED = 12.dp
