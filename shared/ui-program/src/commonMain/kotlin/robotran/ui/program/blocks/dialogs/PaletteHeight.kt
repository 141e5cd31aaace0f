package robotran.ui.program.blocks.dialogs

import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.platform.LocalDensity
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import robotran.blockediting.palette.PaletteBlock
import robotran.robolang.words.BlockGroup
import robotran.ui.program.blocks.BlockScope

/** Where the groups of the palette are, and what they show. */
internal enum class PaletteGroups(internal val height: Dp) {
    /** On the rail beside the blocks. */
    BESIDE(0.dp),

    /** Two rows in the sheet, with names. */
    NAMES(132.dp),

    /** In the sheet by their signs alone, with the name of the one that is shown. */
    SIGNS(108.dp),
    ;

    companion object {
        /** For a sheet in [room] with the font scale [textScale]. */
        fun of(room: BlocksRoom, textScale: Float): PaletteGroups =
            if (room.paletteHeight >= NAMES_FROM && textScale <= NAMES_UP_TO) NAMES else SIGNS

        /** In a lower sheet, names would leave the blocks no room. */
        private val NAMES_FROM = 380.dp

        /** Larger names do not fit below their signs. */
        private const val NAMES_UP_TO = 1.3f
    }
}

/** How high the palette is to show its largest group, the same for all groups. */
@Composable
internal fun rememberPaletteHeight(scope: BlockScope, introduced: Set<String>?, groups: PaletteGroups): Dp {
    val textScale = LocalDensity.current.fontScale
    val hasMore = introduced != null && !scope.isIntroductionFixed
    return remember(scope.state.program, scope.state.cursor, introduced, scope.brick, groups, textScale) {
        val blocks = paletteBlocks(scope.state, introduced, scope.brick)
        paletteHeight(blocks.groupBy { it.group }, groups, hasMore, textScale)
    }
}

/**
 * The height for the largest of [blocks], if the sentence about a block has two lines.
 *
 * @param hasMore whether a button for all blocks stands below.
 */
internal fun paletteHeight(
    blocks: Map<BlockGroup, List<PaletteBlock>>,
    groups: PaletteGroups,
    hasMore: Boolean,
    textScale: Float,
): Dp {
    val list = blocks.values.maxOfOrNull { group ->
        val headings = if (group.any { it.isValue }) 2 else 1
        group.map { heightOf(it, textScale) }.reduce(Dp::plus) + HEADING * textScale * headings
    } ?: 0.dp
    return FIELD * textScale.coerceAtLeast(1f) + groups.height + list + (if (hasMore) MORE else 0.dp) + BELOW
}

private fun heightOf(block: PaletteBlock, textScale: Float): Dp =
    FIRST_LINE + LATER_LINE * block.template.count { it == '\n' } + SENTENCE * textScale + BETWEEN

/** The field of the search and the space below it. */
private val FIELD = 72.dp
private val HEADING = 38.dp
private val FIRST_LINE = 54.dp
private val LATER_LINE = 46.dp
private val SENTENCE = 40.dp
private val BETWEEN = 8.dp
private val MORE = 56.dp
private val BELOW = 16.dp
