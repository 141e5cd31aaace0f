package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.StrokeCap
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
    private val corners = shape.corners().map(transform::toPixels)
    val centre = transform.toPixels(shape.centre)
    val outline = Outline.of(shape, transform)
    val lineWidth = max(LINE_CENTIMETRES * transform.pixelsPerCentimetre, transform.least)
    val grain = Outline(
        when (shape) {
            is Shape.Circle -> rings(shape.radius.toFloat() * transform.pixelsPerCentimetre)
            is Shape.Rectangle -> boards(lengthwise = shape.width >= shape.height)
            is Shape.Polygon -> grain(transform)
        },
    )

    private fun rings(radius: Float) = PARTS.map { Outline.Circle(centre, radius * it) }

    /** Along its longer side. */
    private fun boards(lengthwise: Boolean): List<Outline.Part> {
        val (first, second, third, fourth) = corners
        return PARTS.map { part ->
            val from = if (lengthwise) first.part(fourth, part) else first.part(second, part)
            val to = if (lengthwise) second.part(third, part) else fourth.part(third, part)
            Outline.Polyline(listOf(from, to))
        }
    }

    private fun grain(transform: SheetTransform): List<Outline.Part> {
        val step = max(GRAIN_CENTIMETRES * transform.pixelsPerCentimetre, MIN_GRAIN_PIXELS * transform.least)
        return hatching(corners, step, Offset(0f, 1f), lineWidth).chunked(2) { Outline.Polyline(it.toList()) }
    }

    private fun Offset.part(other: Offset, part: Float) = this + (other - this) * part
}

/** A wooden block with its grain, from above. */
internal fun DrawTarget.drawBlock(block: BlockDrawing, moved: Pose, transform: SheetTransform) =
    atBlock(block, moved, transform) {
        shape(block.outline, SheetColours.BLOCK)
        shape(block.grain, edge = SheetColours.BLOCK_GRAIN, line = Line(block.lineWidth, StrokeCap.Round))
        shape(block.outline, edge = SheetColours.BLOCK_EDGE, line = Line(block.lineWidth * 2))
    }

/** Draws where the block is now, and [shift] away from that. */
internal fun DrawTarget.atBlock(
    block: BlockDrawing,
    moved: Pose,
    transform: SheetTransform,
    shift: Offset = Offset.Zero,
    draw: DrawTarget.() -> Unit,
) {
    val scale = transform.pixelsPerCentimetre
    val move = Offset((moved.x * scale).toFloat() + shift.x, (-moved.y * scale).toFloat() + shift.y)
    group(move, -moved.heading.toFloat(), block.centre, content = draw)
}

private const val LINE_CENTIMETRES = 0.15f
private const val GRAIN_CENTIMETRES = 1.2f
private const val MIN_GRAIN_PIXELS = 5f

/** Where the rings of a log and the gaps between boards are. */
private val PARTS = listOf(0.25f, 0.5f, 0.75f)
