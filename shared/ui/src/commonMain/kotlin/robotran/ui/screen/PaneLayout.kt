package robotran.ui.screen

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.MIN_BRICK_WIDTH

/** Where the brick is, and how much of it. */
internal enum class BrickPlacement {
    /** The whole brick, beside the paper. */
    BESIDE,

    /** Only its strip, beside the paper: the whole brick is too high. */
    STRIP_BESIDE,

    /** Only its strip, under the paper: beside it the paper would become too narrow. */
    STRIP_BELOW,
}

/**
 * How paper and brick share the desk. It depends on nothing that changes while a program runs, so nothing on the desk
 * moves then.
 *
 * @property brickWidth how wide the brick, or the column with its strip, is beside the paper.
 * @property hintBeside whether there is room over the brick for what it has to say; otherwise that lies over the paper.
 */
internal data class PaneLayout(val place: BrickPlacement, val brickWidth: Dp, val hintBeside: Boolean) {
    companion object {
        /** For a desk of [width] by [height] with text of [textScale] times the usual size. */
        fun of(width: Dp, height: Dp, textScale: Float, withChips: Boolean): PaneLayout {
            val around = MARGIN * 2 + if (withChips) CHIP + MARGIN else 0.dp
            val widest = minOf(width * BRICK_SHARE, MAX_BRICK_WIDTH)
            val underHint = minOf(widest, (height - around - HINT * textScale - MARGIN) * BRICK_ASPECT)
            val alone = minOf(widest, (height - around) * BRICK_ASPECT).coerceAtLeast(MIN_BRICK_WIDTH)
            val brickWidth = if (underHint >= MIN_BRICK_WIDTH) underHint else alone
            val place = when {
                width - MIN_BRICK_WIDTH - MARGIN < MIN_SHEET_WIDTH -> BrickPlacement.STRIP_BELOW
                (height - around) * BRICK_ASPECT < MIN_BRICK_WIDTH -> BrickPlacement.STRIP_BESIDE
                else -> BrickPlacement.BESIDE
            }
            return PaneLayout(place, brickWidth, place == BrickPlacement.BESIDE && underHint >= MIN_BRICK_WIDTH)
        }

        val MARGIN = 16.dp
        private const val BRICK_SHARE = 0.3f
        private val MAX_BRICK_WIDTH = 300.dp
        private val MIN_SHEET_WIDTH = 400.dp

        /** The buttons for the task and the goals; words may take two lines. */
        private val CHIP = 56.dp

        /** What the brick says in usual text: five lines beside each other's least brick. */
        private val HINT = 134.dp
    }
}
