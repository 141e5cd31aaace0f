package robotran.ui.code

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.remember
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.lerp
import robotran.blockediting.Block
import robotran.robolang.words.BlockGroup
import robotran.uikit.*
import robotran.workshop.blocks.group

/**
 * The colours of a block. [ink] has a contrast of at least 4.5 to 1 with [fill], and [socketInk] with [socket] and
 * [tint].
 *
 * @property fill the ground of its words.
 * @property edge its outline, and the bar beside what is inside of it. It has a contrast of at least 3 to 1 with the
 *   pane.
 * @property socket the ground of its values.
 * @property tint the ground of a value with others inside.
 */
@Immutable
data class BlockLook(
    val fill: Color,
    val edge: Color,
    val ink: Color,
    val socket: Color,
    val socketInk: Color,
    val tint: Color = socket,
)

/** The colours of all blocks in one theme. A group also has a sign, see [GroupSigns]. */
@Immutable
class BlockLooks(private val colours: RobotranColours) {
    private val hasContrast = colours.isHighContrast
    private val byGroup: Map<BlockGroup, BlockLook> = BlockGroup.entries.associateWith { lookOf(it) }

    val note: BlockLook = noteLook()
    val loose = BlockLook(colours.errorPane, colours.error, colours.onPane, colours.pane, colours.onPane)

    /** An empty line, and the room in a block without blocks. */
    val empty = BlockLook(colours.pane, colours.quiet, colours.quiet, colours.pane, colours.onPane)

    fun of(group: BlockGroup): BlockLook = byGroup.getValue(group)

    fun of(block: Block): BlockLook = when (block) {
        is Block.Loose -> loose
        is Block.Comment -> note
        is Block.Blank -> empty
        is Block.Command, is Block.Construct -> block.group?.let { of(it) } ?: loose
    }

    private fun lookOf(group: BlockGroup): BlockLook {
        val hues = BlockColours.HUES.getValue(group)
        val pane = colours.pane
        val ink = colours.onPane
        return when {
            hasContrast && colours.isDark -> BlockLook(pane, hues.light, ink, pane, ink)
            hasContrast -> BlockLook(pane, hues.deep, ink, pane, ink)
            colours.isDark -> BlockLook(hues.fill, hues.fill, WHITE, pane, ink, lerp(pane, hues.fill, TINT_DARK))
            else -> BlockLook(hues.fill, hues.fill, WHITE, WHITE, ink, lerp(WHITE, hues.fill, TINT))
        }
    }

    private fun noteLook(): BlockLook = when {
        hasContrast -> BlockLook(colours.pane, colours.quiet, colours.onPane, colours.pane, colours.onPane)
        colours.isDark -> noteLook(BlockColours.DARK_NOTE, colours.pane)
        else -> noteLook(BlockColours.LIGHT_NOTE, WHITE)
    }

    private fun noteLook(hues: NoteHues, socket: Color) =
        BlockLook(hues.fill, hues.edge, hues.ink, socket, colours.onPane)

    private companion object {
        val WHITE = RobotranColours.ON_COLOUR

        /** How much of its group's colour is in the ground of a value with others inside. */
        const val TINT = 0.14f
        const val TINT_DARK = 0.3f
    }
}

/** The colours of blocks in the current theme. */
@Composable
fun rememberBlockLooks(): BlockLooks {
    val colours = LocalRobotranColours.current
    return remember(colours) { BlockLooks(colours) }
}
