package robotran.ui.sheet

import robotran.world.Paper
import kotlin.math.roundToInt

/**
 * The size of thumbnails of at most [pixels] width with the ratio [aspect] of width to height, on a screen of [density]
 * pixels per dp.
 */
data class PictureBounds(val pixels: Int, val aspect: Float, val density: Float) {
    fun widthFor(paper: Paper): Int =
        (pixels * minOf(1.0, paper.width / paper.height / aspect)).roundToInt().coerceAtLeast(1)

    companion object {
        /** Rounds [width] up, so that small changes of a window's width need no new pictures. */
        fun of(width: Int, height: Int, density: Float): PictureBounds =
            PictureBounds((width + STEP - 1) / STEP * STEP, width.toFloat() / height, density)

        private const val STEP = 40
    }
}
