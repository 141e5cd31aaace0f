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
import robotran.blockediting.palette.PaletteBlock
import robotran.workshop.blocks.BlockDrag
import robotran.workshop.blocks.BlockLoad
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.blocksIn
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
internal class BlockDragging(val rows: LazyListState) : Carrier {
    lateinit var state: BlocksState
    lateinit var density: Density
    lateinit var onEvent: (BlockEvent) -> Unit
    var isRightToLeft = false

    /** The upper left corner of the list on the screen, in pixels. */
    var corner = Offset.Zero

    /** How far down the list is not covered by the palette. A new block lands nowhere below that. */
    var coveredFrom = Float.MAX_VALUE

    /** Where the finger is; null while nothing is carried. */
    var finger: Offset? by mutableStateOf(null)
        private set
    var landing: Landing? by mutableStateOf(null)
        private set

    /** Whether a block of the palette is carried. */
    var isNew by mutableStateOf(false)
        private set
    private var load: BlockLoad? = null

    override fun isGrip(position: Offset): Boolean = with(density) {
        val row = rowAt(position) as? BlockRow.First ?: return false
        val across = if (isRightToLeft) rows.layoutInfo.viewportSize.width - position.x else position.x
        val start = (BlockSizes.GUTTER + BlockSizes.INDENT * row.around.size).toPx()
        across in start..start + BlockSizes.GRIP.toPx()
    }

    override fun take(position: Offset): Boolean {
        val row = rowAt(position) ?: return false
        if (row is BlockRow.Empty) return false
        load = BlockLoad.Blocks(state.runOf(row.block.id))
        moveTo(position)
        return true
    }

    /** Takes up a new [block] of the palette. */
    fun takeNew(block: PaletteBlock, position: Offset) {
        load = BlockLoad.New(block)
        isNew = true
        moveTo(position)
    }

    override fun moveTo(position: Offset) {
        val carried = load ?: return
        finger = position
        val next = if (isNew && position.y > coveredFrom) null else landingAt(position)
        val isElsewhere = landing == null || next?.place != landing?.place
        if (isElsewhere) onEvent(BlockEvent.Dragged(BlockDrag(carried, next?.place)))
        landing = next
    }

    override fun drop() = end(BlockEvent.Dropped)

    override fun cancel() = end(BlockEvent.DragCancelled)

    private fun end(event: BlockEvent) {
        if (load == null) return
        load = null
        isNew = false
        finger = null
        landing = null
        onEvent(event)
    }

    /** How many pixels the list scrolls in this frame, because the finger is near its upper or lower edge. */
    fun scrollAtEdge(): Float = with(density) {
        val y = finger?.y ?: return 0f
        if (isNew && y > coveredFrom) return 0f
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
        if (isInsideLoad(place)) return null
        val depth = place.parent?.let { state.program[it] }?.let { it.head.depth + 1 } ?: 0
        return Landing(place, item.index, isBelow, depth)
    }

    /** Blocks cannot land in themselves. */
    private fun isInsideLoad(place: BlockPlace): Boolean {
        val carried = (load as? BlockLoad.Blocks)?.let { state.program.blocksIn(it.run) }.orEmpty().map { it.id }
        return generateSequence(place.parent) { state.program.placeOf(it)?.parent }.any { it in carried }
    }

    private fun landingAtEnd(): Landing? =
        state.program.endOf(null)?.let { Landing(it, state.list.rows.lastIndex, isBelow = true, depth = 0) }
}

/** From this distance to its edge on the list scrolls, the faster the nearer the finger is. */
private val EDGE = 56.dp

/** The fastest scrolling, in a frame. */
private val SPEED = 12.dp
