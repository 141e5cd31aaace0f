package robotran.ui.program.blocks

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.semantics.getOrNull
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.isFocused
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performSemanticsAction
import robotran.ui.program.keys
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.pass
import robotran.uikit.*
import robotran.workshop.event.ProgramEvent
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertTrue

/** Tests blocks with what a screen reader has: words, places in the tree, and actions. */
@OptIn(ExperimentalTestApi::class)
class BlocksSpeechTest {
    @Test
    fun `a block says its line, its level, and where it is among the others`() = onTabletInBlocks(SQUARE) {
        assertEquals("repeat 4 times, level 1, 2 blocks inside, 1 of 1", words(ProgramTags.block("0")))
        assertEquals("turn left 90 degrees, level 2, 2 of 2 in repeat 4 times", words(ProgramTags.block("2")))
        assertEquals("End of repeat 4 times", words(ProgramTags.block("0-end")))
    }

    @Test
    fun `where a screen reader says level and position of itself, the words of a block do not`() =
        onTabletInBlocks(SQUARE) {
            val turn = "turn left 90 degrees, in repeat 4 times"
            assertEquals(
                TreePlace(1, 1, 1, isOpen = true, "repeat 4 times, 2 blocks inside"),
                place(ProgramTags.block("0")),
            )
            assertEquals(TreePlace(2, 2, 2, isOpen = null, turn), place(ProgramTags.block("2")))
            assertEquals(TreePlace(1, 1, 1, isOpen = null), place(ProgramTags.block("0-end")))
        }

    @Test
    fun `the last action of a block shows all that can be done to it, also while it is not selected`() =
        onTabletInBlocks(SQUARE) {
            val actions = onNodeWithTag(ProgramTags.block("2"))
                .fetchSemanticsNode().config[SemanticsActions.CustomActions]
            runOnUiThread { actions.last().action() }
            pass(200)
            click(ProgramTags.action(ProgramTags.DELETE))
            assertEquals("repeat 4 times\n  forward 20\nend\n", it.text)
        }

    @Test
    fun `a block says that the program stops before it, and that it is folded`() = onTabletInBlocks(SQUARE) {
        it.handle(ProgramEvent.BreakpointToggled(2))
        pass(100)
        assertEquals("the program stops before it", state(ProgramTags.block("1")))
        perform(ProgramTags.block("0"), "Fold up")
        assertEquals("folded up", state(ProgramTags.block("0")))
        assertEquals(false, place(ProgramTags.block("0"))?.isOpen)
    }

    @Test
    fun `a block says its mistake`() = onTabletInBlocks("forward side\n") {
        pass(1_500)
        assertTrue(assertNotNull(state(ProgramTags.block("0"))).contains("side"), "${state("block-0")}")
    }

    @Test
    fun `actions do what fingers do, and an announcement says what was done`() = onTabletInBlocks(SQUARE) {
        perform(ProgramTags.block("1"), "Move down")
        assertEquals("repeat 4 times\n  turn left 90\n  forward 20\nend\n", it.text)
        assertEquals("Moved: forward 20 cm, 2 of 2 in repeat 4 times", words(ProgramTags.BLOCKS_SAID))
        perform(ProgramTags.block("1"), "Duplicate")
        assertEquals("Duplicated: forward 20 cm, 3 of 3 in repeat 4 times", words(ProgramTags.BLOCKS_SAID))
        perform(ProgramTags.block("2"), "Delete")
        assertEquals("Deleted: turn left 90 degrees", words(ProgramTags.BLOCKS_SAID))
        assertEquals("repeat 4 times\n  forward 20\n  forward 20\nend\n", it.text)
    }

    @Test
    fun `a program is built with actions alone`() = onTabletInBlocks("beep\n") {
        perform(ProgramTags.block("0"), "Add a block below")
        click(ProgramTags.take("move"))
        click(socketOf(it.text, "20"))
        click(ProgramTags.digit('7'))
        click(ProgramTags.BLOCK_SHEET_CLOSE)
        assertEquals("beep\nforward 7\n", it.text)
    }

    @Test
    fun `the keyboard's focus is told at the row and at the part of it`() = onTabletInBlocks(SQUARE) {
        focusBlocks()
        keys(listOf(Key.DirectionDown, Key.DirectionDown))
        assertEquals(ProgramTags.block("1"), focusedTag())
        keys(listOf(Key.DirectionRight, Key.DirectionRight))
        assertEquals(socketOf(SQUARE, "20"), focusedTag())
    }

    /** The innermost element that says that it has the focus. */
    private fun ComposeUiTest.focusedTag(): String? =
        onAllNodes(isFocused()).fetchSemanticsNodes().last().config.getOrNull(SemanticsProperties.TestTag)

    private fun ComposeUiTest.words(tag: String): String? = onNodeWithTag(tag).fetchSemanticsNode()
        .config.getOrNull(SemanticsProperties.ContentDescription)?.joinToString()

    private fun ComposeUiTest.state(tag: String): String? =
        onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(SemanticsProperties.StateDescription)

    private fun ComposeUiTest.place(tag: String): TreePlace? =
        onNodeWithTag(tag).fetchSemanticsNode().config.getOrNull(TreePlaceKey)

    private fun ComposeUiTest.perform(tag: String, action: String) {
        val actions = onNodeWithTag(tag).fetchSemanticsNode().config[SemanticsActions.CustomActions]
        runOnUiThread { actions.first { it.label == action }.action() }
        pass(200)
    }

    private fun ComposeUiTest.click(tag: String) {
        onNodeWithTag(tag).performSemanticsAction(SemanticsActions.OnClick)
        pass(200)
    }

    private companion object {
        const val SQUARE = "repeat 4 times\n  forward 20\n  turn left 90\nend\n"
    }
}
