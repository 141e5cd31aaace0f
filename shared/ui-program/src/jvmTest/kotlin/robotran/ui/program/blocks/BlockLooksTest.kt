package robotran.ui.program.blocks

import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.luminance
import robotran.robolang.words.BlockGroup
import robotran.robolang.words.LineForm
import robotran.ui.code.BlockLook
import robotran.ui.code.BlockLooks
import robotran.ui.code.BlockSigns
import robotran.ui.code.GroupSigns
import robotran.uikit.*
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertTrue

/** Tests that blocks can be read in all themes. */
class BlockLooksTest {
    @Test
    fun `the words on all blocks and in all sockets have enough contrast`() {
        for ((theme, colours) in THEMES) {
            for ((name, look) in looksOf(colours)) {
                assertContrast(look.ink, look.fill, WORDS, "$theme, $name: words")
                assertContrast(look.socketInk, look.socket, WORDS, "$theme, $name: words in sockets")
                assertContrast(look.socketInk, look.tint, WORDS, "$theme, $name: words in sockets with others inside")
            }
        }
    }

    @Test
    fun `all blocks stand out from the pane, and sockets from their block`() {
        for ((theme, colours) in THEMES) {
            for ((name, look) in looksOf(colours)) {
                assertContrast(look.edge, colours.pane, SHAPES, "$theme, $name: outline on the pane")
                val around = if (look.edge == look.fill) look.fill else look.edge
                assertContrast(look.socket, around, SHAPES, "$theme, $name: socket on the block")
            }
        }
    }

    @Test
    fun `the words on the running block have enough contrast`() {
        for ((theme, colours) in THEMES) assertContrast(colours.onPane, colours.runningLine, WORDS, theme)
        assertContrast(RobotranColours.ON_YELLOW, RobotranColours.YELLOW, WORDS, "the arrow in the gutter")
        assertContrast(Color.White, RobotranColours.ON_OFF_RED, WORDS, "a breakpoint")
    }

    @Test
    fun `each group has a sign and a colour of its own`() {
        assertEquals(BlockGroup.entries.size, BlockGroup.entries.map { GroupSigns.of(it) }.toSet().size)
        for ((theme, colours) in THEMES) {
            val looks = BlockLooks(colours)
            assertEquals(BlockGroup.entries.size, BlockGroup.entries.map { looks.of(it).edge }.toSet().size, theme)
        }
    }

    @Test
    fun `turning and driving back have signs of their own, in which the side can be seen`() {
        val lines = mapOf(
            "forward 20" to LineForm.MOVE,
            "backward 20" to LineForm.MOVE,
            "turn left 90" to LineForm.TURN,
            "turn right 90" to LineForm.TURN,
            "stop" to LineForm.STOP,
        )
        assertEquals(lines.size, lines.map { (line, form) -> BlockSigns.of(form, line) }.toSet().size)
        assertEquals(
            BlockSigns.of(LineForm.TURN, "turn right 90"),
            BlockSigns.of(LineForm.START_TURNING, "start turning Right"),
        )
        assertEquals(GroupSigns.of(BlockGroup.CONTROL), BlockSigns.of(LineForm.REPEAT, "repeat 4 times"))
    }

    private fun looksOf(colours: RobotranColours): Map<String, BlockLook> {
        val looks = BlockLooks(colours)
        return BlockGroup.entries.associate { it.name to looks.of(it) } +
            mapOf("note" to looks.note, "loose text" to looks.loose, "empty" to looks.empty)
    }

    private fun assertContrast(one: Color, other: Color, least: Float, described: String) {
        val (light, dark) = listOf(one.luminance(), other.luminance()).sortedDescending()
        val contrast = (light + GLARE) / (dark + GLARE)
        assertTrue(contrast >= least, "$described: the contrast is only $contrast")
    }

    private companion object {
        /** The least contrast of words (WCAG 2.2, 1.4.3), and of what is not words (1.4.11). */
        const val WORDS = 4.5f
        const val SHAPES = 3f

        /** The light that a screen reflects, in the definition of contrast by WCAG. */
        const val GLARE = 0.05f
        val THEMES = mapOf(
            "light" to RobotranColours.LIGHT,
            "dark" to RobotranColours.DARK,
            "high contrast" to RobotranColours.HIGH_CONTRAST,
            "high contrast, dark" to RobotranColours.HIGH_CONTRAST_DARK,
        )
    }
}
