package robotran.ui.sheet

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.geometry.Size
import kotlin.math.min

/**
 * Maps the paper's centimetres, with their origin at its lower left corner and y upwards, to pixels with theirs at the upper left.
 *
 * @property paper the paper's edges in pixels.
 */
class SheetTransform private constructor(
    val pixelsPerCentimetre: Float,
    val paper: Rect,
) {
    /** Where the point [x], [y] centimetres from the paper's lower left corner is. */
    fun toPixels(x: Double, y: Double): Offset =
        Offset(paper.left + x.toFloat() * pixelsPerCentimetre, paper.bottom - y.toFloat() * pixelsPerCentimetre)

    companion object {
        /**
         * The largest paper of [widthCentimetres] by [heightCentimetres] that fits into [area] pixels with [marginCentimetres] of desk
         * on every side, in the middle.
         */
        fun fitting(widthCentimetres: Double, heightCentimetres: Double, marginCentimetres: Double, area: Size): SheetTransform {
            val scale = min(
                area.width / (widthCentimetres + 2 * marginCentimetres),
                area.height / (heightCentimetres + 2 * marginCentimetres),
            ).toFloat().coerceAtLeast(0f)
            val size = Size(widthCentimetres.toFloat() * scale, heightCentimetres.toFloat() * scale)
            val corner = Offset((area.width - size.width) / 2, (area.height - size.height) / 2)
            return SheetTransform(scale, Rect(corner, size))
        }
    }
}
