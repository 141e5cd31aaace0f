package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.StrokeCap
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import androidx.compose.ui.graphics.drawscope.withTransform
import robotran.world.geometry.Pose
import robotran.world.geometry.Shape
import robotran.world.geometry.centre
import kotlin.math.max

/**
 * A block at its place in the world, prepared for drawing at any pose.
 *
 * @property grain the rings of a log, or the grain of a board.
 */
class BlockDrawing(shape: Shape, transform: SheetTransform) {
    private val corners = shape.corners().map { transform.toPixels(it.x, it.y) }
    val centre = transform.toPixels(shape.centre.x, shape.centre.y)
    val path = pathOf(shape, transform)
    val grain = Path()
    val lineWidth = max(LINE_CENTIMETRES * transform.pixelsPerCentimetre, 1f)

    init {
        when (shape) {
            is Shape.Circle -> addRings(shape.radius.toFloat() * transform.pixelsPerCentimetre)
            is Shape.Rectangle -> addBoards(lengthwise = shape.width >= shape.height)
            is Shape.Polygon -> addGrain(transform)
        }
    }

    private fun addRings(radius: Float) {
        for (part in RINGS) grain.addOval(Rect(centre, radius * part))
    }

    /** Along its longer side. */
    private fun addBoards(lengthwise: Boolean) {
        val (first, second, third, fourth) = corners
        for (part in BOARDS) {
            val from = if (lengthwise) first.part(fourth, part) else first.part(second, part)
            val to = if (lengthwise) second.part(third, part) else fourth.part(third, part)
            grain.addLine(listOf(from, to))
        }
    }

    private fun addGrain(transform: SheetTransform) {
        val step = max(GRAIN_CENTIMETRES * transform.pixelsPerCentimetre, MIN_GRAIN_PIXELS)
        for (ends in hatching(corners, step, Offset(0f, 1f), lineWidth).chunked(2)) grain.addLine(ends)
    }

    private fun Offset.part(other: Offset, part: Float) = this + (other - this) * part
}

/** A wooden block with its grain, from above. */
internal fun DrawScope.drawBlock(block: BlockDrawing, moved: Pose, transform: SheetTransform) {
    atBlock(block, moved, transform, Offset.Zero) {
        drawPath(block.path, SheetColours.BLOCK)
        drawPath(block.grain, SheetColours.BLOCK_GRAIN, style = Stroke(block.lineWidth, cap = StrokeCap.Round))
        drawPath(block.path, SheetColours.BLOCK_EDGE, style = Stroke(block.lineWidth * 2))
    }
}

/** Its outline, moved by [shift] pixels. */
internal fun DrawScope.drawBlockShadow(
    block: BlockDrawing,
    moved: Pose,
    transform: SheetTransform,
    shift: Offset,
    colour: Color,
) = atBlock(block, moved, transform, shift) { drawPath(block.path, colour) }

private inline fun DrawScope.atBlock(
    block: BlockDrawing,
    moved: Pose,
    transform: SheetTransform,
    shift: Offset,
    draw: DrawScope.() -> Unit,
) {
    val scale = transform.pixelsPerCentimetre
    withTransform({
        translate((moved.x * scale).toFloat() + shift.x, (-moved.y * scale).toFloat() + shift.y)
        rotate(-moved.heading.toFloat(), block.centre)
    }) { draw() }
}

private const val LINE_CENTIMETRES = 0.15f
private const val GRAIN_CENTIMETRES = 1.2f
private const val MIN_GRAIN_PIXELS = 5f
private val RINGS = listOf(0.25f, 0.5f, 0.75f)
private val BOARDS = listOf(0.25f, 0.5f, 0.75f)
