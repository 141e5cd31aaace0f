package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.remember
import androidx.compose.ui.graphics.Color
import robotran.blockediting.Block
import robotran.blockediting.BlockGroup
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
import robotran.workshop.blocks.group

/**
 * The colours of a block. [ink] has a contrast of at least 4.5 to 1 with [fill], and so has [socketInk] with [socket].
 *
 * @property fill the ground of its words.
 * @property edge its outline, and the bar beside what is inside of it.
 * @property socket the ground of its values.
 */
@Immutable
internal data class BlockLook(
    val fill: Color,
    val edge: Color,
    val ink: Color,
    val socket: Color,
    val socketInk: Color,
)

/** The colours of all blocks in one theme. A group also has a sign, see [GroupSigns]. */
@Immutable
internal class BlockLooks(private val colours: RobotranColours) {
    private val byGroup: Map<BlockGroup, BlockLook> = BlockGroup.entries.associateWith { lookOf(it) }

    val note = BlockLook(colours.pane, colours.quiet, colours.quiet, colours.pane, colours.onPane)
    val loose = BlockLook(colours.errorPane, colours.error, colours.onPane, colours.pane, colours.onPane)

    fun of(group: BlockGroup): BlockLook = byGroup.getValue(group)

    fun of(block: Block): BlockLook = when (block) {
        is Block.Loose -> loose
        is Block.Comment, is Block.Blank -> note
        is Block.Command, is Block.Construct -> block.group?.let { of(it) } ?: loose
    }

    private fun lookOf(group: BlockGroup): BlockLook {
        val (strong, light) = HUES.getValue(group)
        return when (colours) {
            RobotranColours.HIGH_CONTRAST -> BlockLook(Color.White, strong, Color.Black, Color.White, Color.Black)

            RobotranColours.HIGH_CONTRAST_DARK -> BlockLook(Color.Black, light, Color.White, Color.Black, Color.White)

            else -> BlockLook(
                strong,
                if (colours.isDark) light else strong,
                Color.White,
                if (colours.isDark) colours.pane else Color.White,
                colours.onPane,
            )
        }
    }

    private companion object {
        /** For each group a strong hue, on which white text can be read, and a light one for black grounds. */
        val HUES: Map<BlockGroup, Pair<Color, Color>> = mapOf(
            BlockGroup.DRIVE to (Color(0xFF1B5E9E) to Color(0xFF9CC8F5)),
            BlockGroup.PEN to (Color(0xFF96307A) to Color(0xFFF0A8DC)),
            BlockGroup.SENSE to (Color(0xFF00696B) to Color(0xFF7FD8D4)),
            BlockGroup.CONTROL to (Color(0xFF8A5200) to Color(0xFFF5C67A)),
            BlockGroup.NUMBERS to (Color(0xFF3B6B1E) to Color(0xFFB4DE92)),
            BlockGroup.LISTS to (Color(0xFF6A45A8) to Color(0xFFCDB5F7)),
            BlockGroup.OWN_COMMANDS to (Color(0xFF9C3D2A) to Color(0xFFF6B3A2)),
            BlockGroup.SHOW_AND_SOUND to (Color(0xFF4F5B66) to Color(0xFFC4CFDA)),
        )
    }
}

/** The colours of blocks in the current theme. */
@Composable
internal fun rememberBlockLooks(): BlockLooks {
    val colours = LocalRobotranColours.current
    return remember(colours) { BlockLooks(colours) }
}
