package robotran.ui.program.blocks.dialogs

import androidx.compose.runtime.staticCompositionLocalOf
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.workshop.blocks.BlockDialog

/**
 * How blocks, palette and sheets share a pane.
 *
 * @property railWidth the width of the rail beside the blocks, which has the groups or, where sheets are over all blocks,
 * a button for the palette; 0 for no rail.
 * @property dialogs where sheets are.
 * @property sheetWidth the most that a sheet is wide.
 * @property sheetHeight the most that a sheet is high.
 * @property paletteHeight the most that the palette is high.
 */
internal data class BlocksRoom(
    val railWidth: Dp,
    val dialogs: SheetPlace,
    val sheetWidth: Dp,
    val sheetHeight: Dp,
    val paletteHeight: Dp,
) {
    /** Whether the groups are beside the blocks. Otherwise they are in the sheet of the palette. */
    val hasGroups: Boolean get() = railWidth > 0.dp && dialogs != SheetPlace.OVER

    /** How much of the width of the blocks is kept free for sheets. */
    val keptFree: Dp get() = if (dialogs == SheetPlace.BESIDE) sheetWidth else 0.dp

    /** The most that [sheet] is high. */
    fun heightOf(sheet: BlockDialog?): Dp = if (sheet == BlockDialog.Palette) paletteHeight else sheetHeight

    /** How much of the height of the blocks, from the bottom, [sheet] covers; 0 if it covers all. */
    fun coveredBy(sheet: BlockDialog?): Dp = if (sheet == null || dialogs != SheetPlace.BELOW) 0.dp else heightOf(sheet)

    companion object {
        /**
         * For blocks on [width] by [height] with the font scale [textScale].
         *
         * @param isVeryLow whether the pane that they are in is, see [PaneHeight].
         */
        fun of(width: Dp, height: Dp, textScale: Float, isVeryLow: Boolean = false): BlocksRoom {
            val scale = 1 + (textScale.coerceAtLeast(1f) - 1) * SCALED
            val rail = if (width >= RAIL_FROM * scale) RAIL * scale else 0.dp
            return when {
                isVeryLow && width >= OVER_FROM -> BlocksRoom(RAIL * scale, SheetPlace.OVER, width, height, height)

                height < LOW && width - rail - BESIDE_WIDTH * scale >= LEFT_BESIDE * scale -> {
                    BlocksRoom(rail, SheetPlace.BESIDE, BESIDE_WIDTH * scale, height, height)
                }

                else -> {
                    val sheet = maxOf(height * SHARE, minOf(height - LEFT_FREE, NUMBER_HEIGHT * scale))
                    val palette = maxOf(height * PALETTE_SHARE, minOf(height - PALETTE_FREE, PALETTE_LEAST * scale))
                    BlocksRoom(rail, SheetPlace.BELOW, WIDEST, sheet, maxOf(palette, sheet))
                }
            }
        }

        /** The largest phones in portrait are narrower. */
        private val RAIL_FROM = 448.dp
        private val RAIL = 76.dp

        /** Words of one line need less than the font scale, because they wrap. */
        private const val SCALED = 0.6f

        /** The narrowest phone in landscape. */
        private val OVER_FROM = 540.dp

        /** A tablet in portrait. */
        private val LOW = 390.dp
        private val BESIDE_WIDTH = 372.dp

        /** Beside a sheet blocks have at least this width. */
        private val LEFT_BESIDE = 190.dp
        private val WIDEST = 640.dp
        private const val SHARE = 0.62f
        private const val PALETTE_SHARE = 0.76f

        /** The row that is edited stays visible. */
        private val LEFT_FREE = 52.dp

        /** Above the palette a part of the row with the cursor stays visible. */
        private val PALETTE_FREE = 36.dp

        /** With this height the palette shows all groups and a block with its sentence. */
        private val PALETTE_LEAST = 340.dp

        /** With this height the sheet of a number does not scroll. */
        private val NUMBER_HEIGHT = 300.dp
    }
}

/** How high the program's pane is for the sheets of blocks. */
internal enum class PaneHeight {
    /** There is room for all. */
    HIGH,

    /** A small phone, or a tablet in portrait: an open sheet has the room of the errors below the program, too. */
    LOW,

    /**
     * A phone in landscape, or a small one below a lesson: blocks have the room of the errors, which have notes at their
     * blocks, and an open sheet has the room of everything in the pane.
     */
    VERY_LOW,
    ;

    companion object {
        /** For a pane of [height] with the font scale [textScale]. */
        fun of(height: Dp, textScale: Float): PaneHeight = when {
            height < VERY_LOW_BELOW -> VERY_LOW
            height < LOW_BELOW * textScale.coerceAtLeast(1f) -> LOW
            else -> HIGH
        }

        private val VERY_LOW_BELOW = 344.dp
        private val LOW_BELOW = 480.dp
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
