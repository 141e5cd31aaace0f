package robotran.ui.screen

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.LEAST_BRICK_WIDTH

/** Where the brick is, and how much of it. */
internal enum class BrickPlace {
    /** The whole brick, beside the paper. */
    BESIDE,

    /** Only its strip, beside the paper: the whole brick is too high. */
    STRIP_BESIDE,

    /** Only its strip, under the paper: beside it the paper would become too narrow. */
    STRIP_BELOW,
}

/**
 * How paper and brick share the desk. It depends on nothing that changes while a program runs, so nothing on the desk moves then.
 *
 * @property brickWidth how wide the brick, or the column with its strip, is beside the paper.
 * @property hintBeside whether there is room over the brick for what it has to say; otherwise that lies over the paper.
 */
internal data class DeskPlan(val place: BrickPlace, val brickWidth: Dp, val hintBeside: Boolean) {
    companion object {
        /** For a desk of [width] by [height] with text of [textScale] times the usual size. */
        fun of(width: Dp, height: Dp, textScale: Float, withChips: Boolean): DeskPlan {
            val around = MARGIN * 2 + if (withChips) CHIP + MARGIN else 0.dp
            val widest = minOf(width * BRICK_SHARE, MOST_BRICK_WIDTH)
            val underHint = minOf(widest, (height - around - HINT * textScale - MARGIN) * BRICK_ASPECT)
            val alone = minOf(widest, (height - around) * BRICK_ASPECT).coerceAtLeast(LEAST_BRICK_WIDTH)
            val brickWidth = if (underHint >= LEAST_BRICK_WIDTH) underHint else alone
            val place = when {
                width - LEAST_BRICK_WIDTH - MARGIN < LEAST_SHEET_WIDTH -> BrickPlace.STRIP_BELOW
                (height - around) * BRICK_ASPECT < LEAST_BRICK_WIDTH -> BrickPlace.STRIP_BESIDE
                else -> BrickPlace.BESIDE
            }
            return DeskPlan(place, brickWidth, place == BrickPlace.BESIDE && underHint >= LEAST_BRICK_WIDTH)
        }

        val MARGIN = 16.dp
        private const val BRICK_SHARE = 0.3f
        private val MOST_BRICK_WIDTH = 300.dp
        private val LEAST_SHEET_WIDTH = 400.dp

        /** The buttons for the task and the goals; words may take two lines. */
        private val CHIP = 56.dp

        /** What the brick says in usual text: five lines beside each other's least brick. */
        private val HINT = 134.dp
    }
}
