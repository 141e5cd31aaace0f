package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import robotran.world.geometry.Point
import kotlin.math.min

/**
 * Maps the paper's centimetres, with the origin at its lower left corner and y upwards, to pixels, with the origin at
 * the upper left.
 *
 * @property paper the paper's edges in pixels.
 * @property least the size of what is just visible, in pixels: thin lines are drawn at least some of these wide.
 */
class SheetTransform(val pixelsPerCentimetre: Float, val paper: Rect, val least: Float = 1f) {
    /** The pixel position of the point [x], [y] in centimetres from the paper's lower left corner. */
    fun toPixels(x: Double, y: Double): Offset =
        Offset(paper.left + x.toFloat() * pixelsPerCentimetre, paper.bottom - y.toFloat() * pixelsPerCentimetre)

    fun toPixels(point: Point): Offset = toPixels(point.x, point.y)

    /** The length of [centimetres] in pixels. */
    fun toPixels(centimetres: Double): Float = centimetres.toFloat() * pixelsPerCentimetre

    /** The point of the paper, or of the desk beside it, at [position]; the paper's corner if the sheet has no size. */
    fun toCentimetres(position: Offset): Point {
        if (pixelsPerCentimetre == 0f) return Point(0.0, 0.0)
        return Point(toCentimetres(position.x - paper.left), toCentimetres(paper.bottom - position.y))
    }

    /** The length of [pixels] in centimetres; 0 if the sheet has no size. */
    fun toCentimetres(pixels: Float): Double = if (pixelsPerCentimetre == 0f) {
        0.0
    } else {
        (pixels / pixelsPerCentimetre).toDouble()
    }

    override fun equals(other: Any?) =
        other is SheetTransform && pixelsPerCentimetre == other.pixelsPerCentimetre && paper == other.paper

    override fun hashCode() = 31 * pixelsPerCentimetre.hashCode() + paper.hashCode()

    companion object {
        /**
         * Scales and centres paper of [widthCentimetres] by [heightCentimetres] to fit into [area] pixels, with
         * [marginCentimetres] of desk on each side.
         */
        fun fitting(
            widthCentimetres: Double,
            heightCentimetres: Double,
            marginCentimetres: Double,
            area: Size,
        ): SheetTransform = fitting(widthCentimetres, heightCentimetres, marginCentimetres, Rect(Offset.Zero, area))

        /** The same within a rectangle. */
        fun fitting(
            widthCentimetres: Double,
            heightCentimetres: Double,
            marginCentimetres: Double,
            area: Rect,
        ): SheetTransform {
            val scale = min(
                area.width / (widthCentimetres + 2 * marginCentimetres),
                area.height / (heightCentimetres + 2 * marginCentimetres),
            ).toFloat().coerceAtLeast(0f)
            val size = Size(widthCentimetres.toFloat() * scale, heightCentimetres.toFloat() * scale)
            val corner = Offset(area.left + (area.width - size.width) / 2, area.top + (area.height - size.height) / 2)
            return SheetTransform(scale, Rect(corner, size))
        }
    }
}
