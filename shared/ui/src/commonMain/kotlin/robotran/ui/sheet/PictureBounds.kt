package robotran.ui.sheet

import robotran.world.Paper
import kotlin.math.roundToInt

/**
 * The room for pictures that are all [pixels] wide at most, or as high as [aspect] says, on a screen of [density]
 * pixels a dp.
 */
internal data class PictureBounds(val pixels: Int, val aspect: Float, val density: Float) {
    fun widthFor(paper: Paper): Int =
        (pixels * minOf(1.0, paper.width / paper.height / aspect)).roundToInt().coerceAtLeast(1)

    companion object {
        /** A little more than [width], so that not every change of a window's width needs new pictures. */
        fun of(width: Int, height: Int, density: Float): PictureBounds =
            PictureBounds((width + STEP - 1) / STEP * STEP, width.toFloat() / height, density)

        private const val STEP = 40
    }
}
