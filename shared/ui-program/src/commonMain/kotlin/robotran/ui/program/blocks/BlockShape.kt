package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Matrix
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.StrokeJoin
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.LayoutDirection
import androidx.compose.ui.unit.dp
import robotran.blockediting.Block
import robotran.workshop.blocks.BlockRow

/**
 * The shape of one row of a block. A bump at the bottom fits into the notch of the block below, and the first line, the
 * bar and the `end` of a block are one body.
 *
 * @property notch where the notch begins; null for none.
 * @property bump where the bump begins; null for none. It is drawn below the row.
 * @property isOpenAbove whether the bar comes from above.
 * @property isOpenBelow whether the bar goes on below.
 */
internal data class BlockShape(val notch: Dp?, val bump: Dp?, val isOpenAbove: Boolean, val isOpenBelow: Boolean) {
    /** The outline in an area of this size. */
    fun DrawScope.outline(): Path {
        val radius = BlockSizes.CORNER.toPx()
        val width = size.width
        val height = size.height
        val path = Path().apply {
            val above = if (isOpenAbove) 0f else radius
            val below = if (isOpenBelow) 0f else radius
            moveTo(above, 0f)
            notch?.let { step(it.toPx(), 0f, forward = true, this@outline) }
            lineTo(width - radius, 0f)
            quadraticTo(width, 0f, width, radius)
            lineTo(width, height - radius)
            quadraticTo(width, height, width - radius, height)
            bump?.let { step(it.toPx(), height, forward = false, this@outline) }
            lineTo(below, height)
            quadraticTo(0f, height, 0f, height - below)
            lineTo(0f, above)
            quadraticTo(0f, 0f, above, 0f)
            close()
        }
        return inReadingDirection(path)
    }

    /** The rounded inner corners between the row and its bar, which lie outside of the row. */
    fun DrawScope.fillets(): Path {
        val bar = BlockSizes.BAR.toPx()
        val radius = (BlockSizes.INDENT - BlockSizes.BAR).toPx()
        val path = Path().apply {
            if (isOpenBelow) fillet(bar, size.height, radius)
            if (isOpenAbove) fillet(bar, 0f, -radius)
        }
        return inReadingDirection(path)
    }

    private fun DrawScope.inReadingDirection(path: Path): Path {
        if (layoutDirection == LayoutDirection.Rtl) {
            path.transform(
                Matrix().apply {
                    scale(x = -1f)
                    translate(x = -size.width)
                },
            )
        }
        return path
    }

    /** The slanted step of a notch or a bump in a line at [y]. */
    private fun Path.step(start: Float, y: Float, forward: Boolean, scope: DrawScope) = with(scope) {
        val slant = SLANT.toPx()
        val places = listOf(
            Offset(start, y),
            Offset(start + slant, y + STEP.toPx()),
            Offset(start + WIDTH.toPx() - slant, y + STEP.toPx()),
            Offset(start + WIDTH.toPx(), y),
        )
        for (place in if (forward) places else places.reversed()) lineTo(place.x, place.y)
    }

    private fun Path.fillet(x: Float, y: Float, radius: Float) {
        val across = if (radius < 0) -radius else radius
        moveTo(x, y)
        lineTo(x + across, y)
        quadraticTo(x, y, x, y + radius)
        close()
    }

    companion object {
        private val NOTCH = 18.dp
        private val WIDTH = 22.dp
        private val STEP = 4.dp
        private val SLANT = 4.dp
        private val INNER = BlockSizes.INDENT + NOTCH

        /** A line of a block of the palette. */
        fun ofLine(isFirst: Boolean, isLast: Boolean): BlockShape =
            BlockShape(if (isFirst) NOTCH else INNER, if (isLast) NOTCH else INNER, !isFirst, !isLast)

        fun of(row: BlockRow): BlockShape {
            val isOuter = row.block.head.form?.isOutermost == true
            return when (row) {
                is BlockRow.First -> {
                    val isOpen = row.block is Block.Construct && !row.isCollapsed
                    val bump = when {
                        isOpen -> INNER
                        row.block is Block.Command || row.block is Block.Construct -> NOTCH
                        else -> null
                    }
                    BlockShape(NOTCH.takeIf { !isOuter }, bump, isOpenAbove = false, isOpenBelow = isOpen)
                }

                is BlockRow.Branch -> BlockShape(INNER, INNER, isOpenAbove = true, isOpenBelow = true)
                is BlockRow.End -> BlockShape(INNER, NOTCH.takeIf { !isOuter }, isOpenAbove = true, isOpenBelow = false)
                is BlockRow.Empty -> BlockShape(NOTCH, null, isOpenAbove = false, isOpenBelow = false)
            }
        }
    }
}

/**
 * How the outline of a block is drawn.
 *
 * @property halo a wider line below it, which sets it off from the block.
 */
internal data class BlockOutline(
    val colour: Color,
    val width: Dp,
    val isDashed: Boolean = false,
    val halo: Color? = null,
)

/** The block in [fill] with its [outline]; [join] is the colour of the bar that it is joined to. */
internal fun DrawScope.drawBlock(shape: BlockShape, fill: Color, join: Color, outline: BlockOutline?) = with(shape) {
    val path = outline()
    drawPath(fillets(), join)
    drawPath(path, fill)
    if (outline == null) return@with
    outline.halo?.let { drawPath(path, it, style = Stroke((outline.width + HALO).toPx(), join = StrokeJoin.Round)) }
    val dashes = PathEffect.dashPathEffect(floatArrayOf(DASH.toPx(), DASH.toPx())).takeIf { outline.isDashed }
    drawPath(path, outline.colour, style = Stroke(outline.width.toPx(), join = StrokeJoin.Round, pathEffect = dashes))
}

private val HALO = 4.dp
private val DASH = 6.dp
