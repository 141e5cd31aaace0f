package robotran.ui.program.blocks

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.runtime.MutableState
import androidx.compose.runtime.Stable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.unit.Density
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.PaletteBlock
import robotran.language.source.SourceSpan
import robotran.robolang.words.ValueForm
import robotran.uikit.*
import robotran.workshop.blocks.BlockRow
import robotran.workshop.blocks.BlockTarget
import robotran.workshop.blocks.BlocksState
import robotran.workshop.blocks.DragPayload
import robotran.workshop.event.BlockEvent

/**
 * Carries blocks and values over the list [rows]. Positions are in pixels from its upper left corner.
 *
 * @param hasFocus whether the list has the keyboard's focus.
 */
@Stable
internal class BlockDragging(val rows: LazyListState, hasFocus: MutableState<Boolean> = mutableStateOf(false)) :
    Carrier {
    lateinit var state: BlocksState
    lateinit var density: Density
    lateinit var onEvent: (BlockEvent) -> Unit
    var isRightToLeft = false
    val sockets = SocketPlaces()

    /** Whether the list has the keyboard's focus. */
    var hasFocus by hasFocus

    /** Gives the list the keyboard's focus. */
    var focus: FocusRequester? = null

    /** Whether Shift was held when a pointer went down last. */
    var isShiftHeld = false

    /** The upper left corner of the list on the screen, in pixels. */
    var corner = Offset.Zero

    /** How far down the list is not covered by the palette. A new block lands nowhere below that, nor beside the list. */
    var coveredFrom = Float.MAX_VALUE

    /** The place of the bin; null if there is none. */
    var bin: Rect? = null

    /** What is carried; null if nothing. Composition reads this and not [finger], which changes in each frame. */
    var load: DragPayload? by mutableStateOf(null)
        private set
    val isCarrying: Boolean get() = load != null

    /** Where the finger is; null while nothing is carried. */
    var finger: Offset? by mutableStateOf(null)
        private set
    var landing: Landing? by mutableStateOf(null)
        private set

    /** Where what is carried goes if it is let go; null if nowhere. */
    var target: BlockTarget? by mutableStateOf(null)
        private set

    /** Whether a block of the palette is carried. */
    val isNew: Boolean get() = load is DragPayload.New

    /** The value that is carried; null if none is. */
    var value: CarriedValue? by mutableStateOf(null)
        private set

    override fun isGrip(position: Offset): Boolean = with(density) {
        val row = rowAt(position) as? BlockRow.First ?: return false
        val across = if (isRightToLeft) rows.layoutInfo.viewportSize.width - position.x else position.x
        val start = (BlockSizes.GUTTER + BlockSizes.INDENT * row.around.size).toPx()
        across in start..start + BlockSizes.GRIP.toPx()
    }

    override fun onDown(isShiftHeld: Boolean) {
        this.isShiftHeld = isShiftHeld
        focus?.requestFocus()
    }

    override fun take(position: Offset): Boolean {
        val part = sockets.at(position).map { it.first }.firstOrNull { it.value.form != ValueForm.NUMBER }
        val row = rowAt(position) ?: return false
        when {
            part != null -> take(DragPayload.Value(part.span), CarriedValue(part, state.program), position)
            row is BlockRow.Empty -> return false
            else -> take(DragPayload.Blocks(state.runOf(row.block.id)), null, position)
        }
        return true
    }

    /** Takes up a new [block] of the palette. */
    fun takeNew(block: PaletteBlock, position: Offset) {
        take(DragPayload.New(block), if (block.isValue) CarriedValue(block) else null, position)
    }

    private fun take(load: DragPayload, value: CarriedValue?, position: Offset) {
        this.load = load
        this.value = value
        moveTo(position)
    }

    override fun moveTo(position: Offset) {
        if (load == null) return
        finger = position
        val isCovered = isNew && !isOnList(position)
        val isBinned = !isNew && bin?.contains(position) == true
        landing = if (isCovered || isBinned || value != null) null else landingAt(position, rows, state, load)
        target = when {
            isCovered -> null
            isBinned -> BlockTarget.Bin
            else -> landing?.let { BlockTarget.Between(it.place) } ?: socketAt(position)?.let { BlockTarget.Socket(it) }
        }
    }

    /** Whether [position] is on the part of the list that the palette does not cover. */
    private fun isOnList(position: Offset): Boolean {
        val (width, height) = rows.layoutInfo.viewportSize
        return position.x in 0f..width.toFloat() && position.y in 0f..minOf(coveredFrom, height.toFloat())
    }

    override fun drop() {
        val carried = load ?: return
        val place = target
        cancel()
        // The program hears of this only now, since it would show all blocks anew for each place on the way.
        if (place != null) onEvent(BlockEvent.Dropped(carried, place))
    }

    override fun cancel() {
        load = null
        value = null
        finger = null
        landing = null
        target = null
    }

    /** How many pixels the list scrolls in this frame, because the finger is near its upper or lower edge. */
    fun scrollAtEdge(): Float = with(density) {
        val y = finger?.y ?: return 0f
        if (target == BlockTarget.Bin) return 0f
        val edge = EDGE.toPx()
        val height = rows.layoutInfo.viewportSize.height
        val end = if (isNew && coveredFrom < height) coveredFrom else height.toFloat()
        if (isNew && y > end) return 0f
        val beyond = when {
            y < edge -> y - edge
            y > end - edge -> y - (end - edge)
            else -> 0f
        }
        (beyond / edge).coerceIn(-1f, 1f) * SPEED.toPx()
    }

    private fun rowAt(position: Offset): BlockRow? = rows.itemAt(position)?.let { state.list.rows.getOrNull(it.index) }

    /** The socket at [position], or one near it, where the value fits. */
    private fun socketAt(position: Offset): SourceSpan? = value?.let { carried ->
        sockets.nearest(position, with(density) { REACH.toPx() }, carried::fitsAt)?.span
    }
}

/** A finger hides the socket below it, so what is near counts, too. */
private val REACH = 16.dp

/** From this distance to its edge on the list scrolls, the faster the nearer the finger is. */
private val EDGE = 56.dp

/** The fastest scrolling, in a frame. */
private val SPEED = 12.dp
