package robotran.ui.program.blocks

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.BoxScope
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.defaultMinSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.draw.shadow
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.layout.onGloballyPositioned
import androidx.compose.ui.layout.positionInRoot
import androidx.compose.ui.platform.testTag
import androidx.compose.ui.semantics.clearAndSetSemantics
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.toSize
import robotran.ui.code.BlockColours
import robotran.ui.program.tags.ProgramTags
import robotran.ui.program.texts.BlockTexts
import robotran.uikit.*
import robotran.workshop.blocks.BlockTarget

/**
 * What appears over the list while something is carried: a ring around each socket where a carried value fits, and the
 * bin. Nothing below moves.
 *
 * @param covered how much of the lower end of the list a sheet covers.
 */
@Composable
internal fun BoxScope.CarryOverlay(dragging: BlockDragging, covered: Dp) {
    if (!dragging.isCarrying) return
    val colour = LocalRobotranColours.current.focus
    Box(
        Modifier.matchParentSize().drawBehind {
            val carried = dragging.value ?: return@drawBehind
            // The sockets move when the list scrolls.
            dragging.rows.firstVisibleItemIndex + dragging.rows.firstVisibleItemScrollOffset
            val over = (dragging.target as? BlockTarget.Socket)?.span
            for ((part, place) in dragging.sockets.all()) {
                if (carried.fitsAt(part)) drawSocket(place, colour, isTarget = part.span == over)
            }
        },
    )
    if (!dragging.isNew) Bin(dragging, Modifier.align(Alignment.BottomEnd).padding(12.dp).padding(bottom = covered))
}

private fun DrawScope.drawSocket(bounds: Rect, colour: Color, isTarget: Boolean) {
    val wide = bounds.inflate(RING.toPx() / 2)
    val corner = CornerRadius(wide.height / 2)
    if (isTarget) drawRoundRect(colour, wide.topLeft, wide.size, corner, alpha = FILL)
    val ring = if (isTarget) RING * 2 else RING
    drawRoundRect(RobotranColours.CASING, wide.topLeft, wide.size, corner, Stroke((ring + 2.dp).toPx()))
    drawRoundRect(colour, wide.topLeft, wide.size, corner, Stroke(ring.toPx()))
}

/** Deletes what is dropped on it. */
@Composable
private fun Bin(dragging: BlockDragging, modifier: Modifier) {
    val colours = LocalRobotranColours.current
    val isOver = dragging.target == BlockTarget.Bin
    val ink = if (isOver) RobotranColours.CASING else colours.onPane
    val shape = Shapes.SHEET
    DisposableEffect(dragging) { onDispose { dragging.bin = null } }
    Row(
        modifier
            .testTag(ProgramTags.BLOCKS_BIN)
            .onGloballyPositioned { dragging.bin = Rect(it.positionInRoot() - dragging.corner, it.size.toSize()) }
            .defaultMinSize(BIN_WIDTH, BIN_HEIGHT)
            .shadow(4.dp, shape)
            .background(if (isOver) BlockColours.OVER_BIN else colours.pane, shape)
            .border(2.dp, if (isOver) RobotranColours.CASING else colours.quiet, shape)
            .padding(horizontal = 16.dp)
            .clearAndSetSemantics { },
        Arrangement.spacedBy(8.dp, Alignment.CenterHorizontally),
        Alignment.CenterVertically,
    ) {
        IconView(BIN, ink, size = 28.dp)
        Text(BlockTexts.delete(spoken), style = TextStyles.body.medium, color = ink)
    }
}

private val BIN = Icon.strokes("M5 7H19", "M9 7V4H15V7", "M7 7L8 20H16L17 7", "M10.5 11V16", "M13.5 11V16")
private val BIN_WIDTH = 120.dp
private val BIN_HEIGHT = 72.dp

private val RING = 2.dp
private const val FILL = 0.35f
