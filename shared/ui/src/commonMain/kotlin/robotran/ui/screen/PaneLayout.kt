package robotran.ui.screen

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.MIN_BRICK_WIDTH

/** The position and the size of the brick. */
internal enum class BrickPlacement {
    /** The whole brick, beside the paper. */
    BESIDE,

    /** Only its strip, beside the paper: the whole brick is too high. */
    STRIP_BESIDE,

    /** Only its strip, below the paper: beside it the paper would be too narrow. */
    STRIP_BELOW,
}

/**
 * The layout of paper and brick. It depends on nothing that changes during a run, so nothing moves.
 *
 * @property brickWidth the width of the brick, or of the column with its strip, beside the paper.
 * @property hintBeside whether there is room above the brick for its message; otherwise it covers the paper.
 */
internal data class PaneLayout(val place: BrickPlacement, val brickWidth: Dp, val hintBeside: Boolean) {
    companion object {
        /** The layout for an area of [width] by [height] with the font scale [textScale]. */
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

        /** The buttons for the task and the goals, with up to two lines of text. */
        private val CHIP = 56.dp

        /** The brick's message at default font size: five lines at the min width of the brick beside the paper. */
        private val HINT = 134.dp
    }
}
