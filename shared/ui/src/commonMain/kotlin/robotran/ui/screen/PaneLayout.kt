package robotran.ui.screen

import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.ui.brick.BRICK_ASPECT
import robotran.ui.brick.MIN_BRICK_WIDTH

/** The position and the size of the brick. */
internal enum class BrickPlacement {
    /** Only its display and Run, in the row below the paper. */
    SMALL,

    /** The whole brick, beside the paper. */
    BESIDE,

    /** The whole brick, over the paper until it is small again: there is no room beside it. */
    OVER,
}

/**
 * The layout of paper and brick. It depends on nothing that changes during a run, so nothing moves.
 *
 * @property brickWidth the width of the whole brick.
 * @property messagesAbove whether there is room above the brick for all messages; otherwise they are beside the paper.
 */
internal data class PaneLayout(val place: BrickPlacement, val brickWidth: Dp, val messagesAbove: Boolean) {
    companion object {
        /** The layout for an area of [width] by [height] with the font scale [textScale]; [isWhole] asks for all of it. */
        fun of(width: Dp, height: Dp, textScale: Float, isWhole: Boolean): PaneLayout {
            if (!isWhole) return PaneLayout(BrickPlacement.SMALL, MIN_BRICK_WIDTH, messagesAbove = false)
            val widest = minOf(width * BRICK_SHARE, MAX_BRICK_WIDTH)
            val underMessages = minOf(widest, (height - MARGIN * 3 - MESSAGES * textScale) * BRICK_ASPECT)
            val alone = minOf(widest, (height - MARGIN * 2) * BRICK_ASPECT).coerceAtLeast(MIN_BRICK_WIDTH)
            val isBeside = width - MIN_BRICK_WIDTH - MARGIN * 2 >= MIN_SHEET_WIDTH &&
                (height - MARGIN * 2) * BRICK_ASPECT >= MIN_BRICK_WIDTH
            val messagesAbove = isBeside && underMessages >= MIN_BRICK_WIDTH
            val place = if (isBeside) BrickPlacement.BESIDE else BrickPlacement.OVER
            return PaneLayout(place, if (messagesAbove) underMessages else alone, messagesAbove)
        }

        val MARGIN = 16.dp
        private const val BRICK_SHARE = 0.3f
        private val MAX_BRICK_WIDTH = 300.dp
        private val MIN_SHEET_WIDTH = 320.dp

        /** At the default font size: a task with its buttons, or an outcome, at the min width of the brick. */
        private val MESSAGES = 240.dp
    }
}
