package robotran.ui.program.blocks.sheets

import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.workshop.blocks.BlockSheet

/**
 * How blocks, palette and sheets share a pane.
 *
 * @property railWidth the width of the groups beside the blocks; 0 if they are in the sheet of the palette.
 * @property sheets where sheets are.
 * @property sheetWidth the most that a sheet is wide.
 * @property sheetHeight the most that a sheet is high.
 * @property paletteHeight the most that the palette is high.
 */
internal data class BlocksRoom(
    val railWidth: Dp,
    val sheets: SheetPlace,
    val sheetWidth: Dp,
    val sheetHeight: Dp,
    val paletteHeight: Dp,
) {
    val hasRail: Boolean get() = railWidth > 0.dp

    /** How much of the width of the blocks is kept free for sheets. */
    val keptFree: Dp get() = if (sheets == SheetPlace.BESIDE) sheetWidth else 0.dp

    /** The most that [sheet] is high. */
    fun heightOf(sheet: BlockSheet?): Dp = if (sheet == BlockSheet.Palette) paletteHeight else sheetHeight

    /** How much of the height of the blocks, from the bottom, [sheet] covers; 0 if it covers all. */
    fun coveredBy(sheet: BlockSheet?): Dp = if (sheet == null || sheets != SheetPlace.BELOW) 0.dp else heightOf(sheet)

    companion object {
        /** For a pane of [width] by [height] and the font scale [textScale]. */
        fun of(width: Dp, height: Dp, textScale: Float): BlocksRoom {
            val scale = 1 + (textScale.coerceAtLeast(1f) - 1) * SCALED
            val rail = if (width >= RAIL_FROM * scale) RAIL * scale else 0.dp
            return when {
                height < VERY_LOW && width >= OVER_FROM -> {
                    BlocksRoom(rail, SheetPlace.OVER, width - rail, height, height)
                }

                height < LOW && width >= BESIDE_FROM -> {
                    BlocksRoom(rail, SheetPlace.BESIDE, BESIDE_WIDTH * scale, height, height)
                }

                else -> {
                    val sheet = maxOf(height * SHARE, minOf(height - LEFT_FREE, NUMBER_HEIGHT * scale))
                    BlocksRoom(rail, SheetPlace.BELOW, WIDEST, sheet, maxOf(height * PALETTE_SHARE, sheet))
                }
            }
        }

        /** The largest phones in portrait are narrower. */
        private val RAIL_FROM = 448.dp
        private val RAIL = 76.dp

        /** Words of one line need less than the font scale, because they wrap. */
        private const val SCALED = 0.6f

        /** A phone in landscape. */
        private val VERY_LOW = 200.dp
        private val OVER_FROM = 680.dp

        /** A tablet in portrait. */
        private val LOW = 340.dp
        private val BESIDE_FROM = 640.dp
        private val BESIDE_WIDTH = 372.dp
        private val WIDEST = 640.dp
        private const val SHARE = 0.62f
        private const val PALETTE_SHARE = 0.76f

        /** The row that is edited stays visible. */
        private val LEFT_FREE = 52.dp

        /** With this height the sheet of a number does not scroll. */
        private val NUMBER_HEIGHT = 300.dp
    }
}

/** Where the sheets of blocks are. */
internal enum class SheetPlace {
    /** Over the lower part of the blocks. */
    BELOW,

    /** Beside the blocks, which are too low for one below. */
    BESIDE,

    /** Over all blocks, with everything side by side. */
    OVER,
}

/** Where the open sheet is. */
internal val LocalSheetPlace = staticCompositionLocalOf { SheetPlace.BELOW }
