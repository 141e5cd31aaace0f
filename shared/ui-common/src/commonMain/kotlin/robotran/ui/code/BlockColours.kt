package robotran.ui.code

import androidx.compose.ui.graphics.Color
import robotran.robolang.words.BlockGroup
import robotran.uikit.*

/**
 * The hues of a group.
 *
 * @property fill a ground for white words, which is also clearly visible on a dark pane.
 * @property deep an outline on white.
 * @property light an outline on black.
 */
class Hues(val fill: Color, val deep: Color, val light: Color)

/** The colours of a comment, which looks like a note stuck on. */
class NoteHues(val fill: Color, val edge: Color, val ink: Color)

/** The colours that blocks are made of; [BlockLooks] chooses from them for a theme. */
object BlockColours {
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

    val LIGHT_NOTE = NoteHues(Color(0xFFFFF3C9), Color(0xFF8C7A33), Color(0xFF4A4018))
    val DARK_NOTE = NoteHues(Color(0xFF3A3523), Color(0xFF8F8459), Color(0xFFF1E7C3))

    /** The bin while something is over it: a red on which white can be read in all themes. */
    val OVER_BIN = Color(0xFFB3261E)
}
