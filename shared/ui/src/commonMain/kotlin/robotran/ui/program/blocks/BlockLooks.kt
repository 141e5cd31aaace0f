package robotran.ui.program.blocks

import androidx.compose.runtime.Composable
import androidx.compose.runtime.Immutable
import androidx.compose.runtime.remember
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.lerp
import robotran.blockediting.Block
import robotran.blockediting.BlockGroup
import robotran.ui.theme.LocalRobotranColours
import robotran.ui.theme.RobotranColours
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
internal data class BlockLook(
    val fill: Color,
    val edge: Color,
    val ink: Color,
    val socket: Color,
    val socketInk: Color,
    val tint: Color = socket,
)

/** The colours of all blocks in one theme. A group also has a sign, see [GroupSigns]. */
@Immutable
internal class BlockLooks(private val colours: RobotranColours) {
    private val hasContrast = colours == RobotranColours.HIGH_CONTRAST || colours == RobotranColours.HIGH_CONTRAST_DARK
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
        val hues = HUES.getValue(group)
        val pane = colours.pane
        val ink = colours.onPane
        return when {
            hasContrast && colours.isDark -> BlockLook(pane, hues.light, ink, pane, ink)
            hasContrast -> BlockLook(pane, hues.deep, ink, pane, ink)
            colours.isDark -> BlockLook(hues.fill, hues.fill, Color.White, pane, ink, lerp(pane, hues.fill, TINT_DARK))
            else -> BlockLook(hues.fill, hues.fill, Color.White, Color.White, ink, lerp(Color.White, hues.fill, TINT))
        }
    }

    private fun noteLook(): BlockLook = when {
        hasContrast -> {
            BlockLook(colours.pane, colours.quiet, colours.onPane, colours.pane, colours.onPane)
        }

        colours.isDark -> {
            BlockLook(Color(0xFF3A3523), Color(0xFF8F8459), Color(0xFFF1E7C3), colours.pane, colours.onPane)
        }

        else -> {
            BlockLook(Color(0xFFFFF3C9), Color(0xFF8C7A33), Color(0xFF4A4018), Color.White, colours.onPane)
        }
    }

    /**
     * The hues of a group.
     *
     * @property fill a ground for white words, which is also clearly visible on a dark pane.
     * @property deep an outline on white.
     * @property light an outline on black.
     */
    private class Hues(val fill: Color, val deep: Color, val light: Color)

    private companion object {
        val HUES: Map<BlockGroup, Hues> = mapOf(
            BlockGroup.DRIVE to Hues(Color(0xFF1F6FC9), Color(0xFF0E4A8A), Color(0xFF9CC8F5)),
            BlockGroup.PEN to Hues(Color(0xFFB8389A), Color(0xFF86206C), Color(0xFFF0A8DC)),
            BlockGroup.SENSE to Hues(Color(0xFF007C7E), Color(0xFF00595B), Color(0xFF7FD8D4)),
            BlockGroup.CONTROL to Hues(Color(0xFFA85F00), Color(0xFF744000), Color(0xFFF5C67A)),
            BlockGroup.NUMBERS to Hues(Color(0xFF3B7D23), Color(0xFF2A5A14), Color(0xFFB4DE92)),
            BlockGroup.LISTS to Hues(Color(0xFF7A55C7), Color(0xFF54339A), Color(0xFFCDB5F7)),
            BlockGroup.OWN_COMMANDS to Hues(Color(0xFFC2452F), Color(0xFF8A2B19), Color(0xFFF6B3A2)),
            BlockGroup.SHOW_AND_SOUND to Hues(Color(0xFF5B6B7A), Color(0xFF3E4A55), Color(0xFFC4CFDA)),
        )

        /** How much of its group's colour is in the ground of a value with others inside. */
        const val TINT = 0.14f
        const val TINT_DARK = 0.3f
    }
}

/** The colours of blocks in the current theme. */
@Composable
internal fun rememberBlockLooks(): BlockLooks {
    val colours = LocalRobotranColours.current
    return remember(colours) { BlockLooks(colours) }
}
