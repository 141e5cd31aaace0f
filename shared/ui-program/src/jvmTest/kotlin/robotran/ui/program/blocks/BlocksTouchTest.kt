package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.test.swipeUp
import robotran.projects.ProgramView
import robotran.robolang.words.BlockGroup
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.assertWhole
import robotran.ui.screen.checkTargets
import robotran.ui.screen.isThere
import robotran.ui.screen.onPhone
import robotran.ui.screen.pass
import robotran.ui.screen.placesByTag
import robotran.ui.screen.scrollAndTouch
import robotran.ui.screen.tags.ScreenTags
import robotran.ui.screen.touch
import robotran.uikit.*
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent
import robotran.workshop.state.Pane
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertFalse
import kotlin.test.assertTrue

/** Tests blocks with a finger and without a keyboard. */
@OptIn(ExperimentalTestApi::class)
class BlocksTouchTest {
    @Test
    fun `a finger switches between text, blocks and both`() = onPhone { workshop ->
        touch(ScreenTags.tab(Pane.PROGRAM))
        touch(ProgramTags.VIEW_SWITCH)
        touch(ProgramTags.view(ProgramView.BLOCKS))
        assertEquals(ProgramView.BLOCKS, workshop.state.programs.view)
        assertEquals(1, onAllNodesWithTag(ProgramTags.BLOCKS).fetchSemanticsNodes().size)
        assertEquals(0, onAllNodesWithTag(ProgramTags.PROGRAM).fetchSemanticsNodes().size)
        touch(ProgramTags.VIEW_SWITCH)
        touch(ProgramTags.view(ProgramView.BOTH))
        assertEquals(1, onAllNodesWithTag(ProgramTags.PROGRAM).fetchSemanticsNodes().size)
    }

    @Test
    fun `a square is built from the palette on a phone`() = onPhoneInBlocks("") { workshop ->
        touch(ProgramTags.BLOCKS_ADD)
        touch(ProgramTags.group(BlockGroup.CONTROL))
        scrollAndTouch(ProgramTags.take("repeat"))
        touch(ProgramTags.BLOCKS_ADD)
        touch(ProgramTags.group(BlockGroup.DRIVE))
        scrollAndTouch(ProgramTags.take("move"))
        touch(ProgramTags.BLOCKS_ADD)
        scrollAndTouch(ProgramTags.take("turn"))
        assertFalse(isThere(ProgramTags.BLOCK_SHEET), "the palette is closed, so that the program is in sight")
        assertEquals("repeat 4 times\n  forward 20\n  turn left 90\nend", workshop.text.trim())
    }

    @Test
    fun `a number is changed with the number pad, and undone at once`() = onPhoneInBlocks(SQUARE) { workshop ->
        touch(socketOf(SQUARE, "20"))
        for (digit in "135") scrollAndTouch(ProgramTags.digit(digit))
        assertEquals(SQUARE.replace("20", "135"), workshop.text)
        scrollAndTouch(ProgramTags.NUMBER_LESS)
        assertEquals(SQUARE.replace("20", "134"), workshop.text)
        touch(ProgramTags.BLOCK_SHEET_CLOSE)
        touch(ProgramTags.UNDO)
        assertEquals(SQUARE, workshop.text)
    }

    @Test
    fun `a second touch on a block opens nothing, wherever it is`() = onTabletInBlocks(SQUARE) { workshop ->
        for (block in listOf("1", "2")) {
            for (part in 0..SPOTS) {
                val spot = touchAt(ProgramTags.block(block), part.toFloat() / SPOTS)
                assertTrue(isThere(ProgramTags.BLOCK_MORE), "the block is chosen")
                touchAt(ProgramTags.block(block), part.toFloat() / SPOTS)
                val sheet = workshop.state.programs.blocks?.sheet
                assertFalse(sheet is BlockDialog.Actions, "a second touch on $block at $spot opens $sheet")
                workshop.handle(BlockEvent.DialogShown(null))
                pass(100)
            }
        }
    }

    @Test
    fun `beside a chosen block a button opens its four usual actions, and deleting is apart`() =
        onTabletInBlocks(SQUARE) {
            touch(ProgramTags.block("1"))
            val block = placeOf(ProgramTags.block("1"))
            assertTrue(placeOf(ProgramTags.BLOCK_MORE).left >= block.right)
            touch(ProgramTags.BLOCK_MORE)
            val usual = listOf(ProgramTags.DUPLICATE, ProgramTags.WRAP, ProgramTags.NOW, ProgramTags.HELP)
            assertEquals(
                (usual + ProgramTags.DELETE).map(ProgramTags::action).toSet(),
                placesByTag().keys.filter { it.startsWith("action-") }.toSet(),
            )
            val lowest = usual.maxOf { placeOf(ProgramTags.action(it)).bottom }
            assertTrue(placeOf(ProgramTags.action(ProgramTags.DELETE)).top > lowest + Dimensions.TARGET.value)
            touch(ProgramTags.ACTIONS_MORE)
            assertTrue(isThere(ProgramTags.action(ProgramTags.CUT)))
        }

    @Test
    fun `the palette has all groups in sight, and nothing in it moves while one goes through them`() =
        onPhoneInBlocks(SQUARE) {
            touch(ProgramTags.BLOCKS_ADD)
            val groups = BlockGroup.entries.map { ProgramTags.group(it) }
            val fixed = groups + listOf(ProgramTags.BLOCK_SHEET, ProgramTags.PALETTE_SEARCH, ProgramTags.PALETTE_BLOCKS)
            val before = fixed.associateWith(::placeOf)
            for (group in groups) {
                assertWhole(group, group)
                touch(group)
                for ((tag, place) in before) assertEquals(place, placeOf(tag), "$tag after $group")
            }
        }

    @Test
    fun `a choice is made in a menu`() = onTabletInBlocks(SQUARE) { workshop ->
        touch(socketOf(SQUARE, "left"))
        touch(ProgramTags.choice(1))
        assertEquals(SQUARE.replace("left", "right"), workshop.text)
    }

    @Test
    fun `a finger that rests on a block carries it to another place`() = onPhoneInBlocks("beep\nbuzz\nstop\n") {
        carry(ProgramTags.block("0"), placeOf(ProgramTags.block("2")).bottomLeft + CLEAR)
        assertEquals("buzz\nstop\nbeep\n", it.text)
    }

    @Test
    fun `a block is carried out of the palette into another one`() = onPhoneInBlocks("repeat 4 times\nend\n") {
        touch(ProgramTags.BLOCKS_ADD)
        val room = onNodeWithTag(ProgramTags.block("0-room-0")).fetchSemanticsNode().boundsInRoot.center
        val from = onNodeWithTag(ProgramTags.take("move")).fetchSemanticsNode().boundsInRoot
        onNodeWithTag(ProgramTags.take("move")).performTouchInput { down(center) }
        pass(800)
        onNodeWithTag(ProgramTags.take("move")).performTouchInput { moveTo(room - from.topLeft) }
        pass(100)
        onNodeWithTag(ProgramTags.take("move")).performTouchInput { up() }
        pass(200)
        assertEquals("repeat 4 times\n  forward 20\nend\n", it.text)
    }

    @Test
    fun `a block is deleted with its inside, and comes back`() = onTabletInBlocks(SQUARE) { workshop ->
        touch(ProgramTags.block("0"))
        touch(ProgramTags.BLOCK_MORE)
        touch(ProgramTags.action(ProgramTags.DELETE))
        assertEquals("", workshop.text.trim())
        touch(ProgramTags.UNDO)
        assertEquals(SQUARE, workshop.text)
    }

    @Test
    fun `a touch on a line's number sets a breakpoint`() = onPhoneInBlocks(SQUARE) { workshop ->
        touch(ProgramTags.blockLine(2))
        assertEquals(setOf(2), workshop.state.programs.breakpoints)
        checkTargets(ProgramTags.blockLine(2), ProgramTags.block("0"), ProgramTags.BLOCKS_ADD, ProgramTags.VIEW_SWITCH)
    }

    @Test
    fun `of a long program only the visible blocks are on the screen`() = onTabletInBlocks(LONG) {
        val before = onAllNodesWithTag(ProgramTags.block("1990")).fetchSemanticsNodes().size
        assertEquals(0, before)
        onNodeWithTag(ProgramTags.BLOCKS).performTouchInput { swipeUp() }
        pass(500)
        assertTrue(onAllNodesWithTag(ProgramTags.block("0")).fetchSemanticsNodes().isEmpty())
    }

    /** Touches the block [tag] at [part] of its width. */
    private fun ComposeUiTest.touchAt(tag: String, part: Float): Offset {
        var spot = Offset.Zero
        onNodeWithTag(tag).performTouchInput {
            spot = Offset(1 + (width - 2) * part, height / 2f)
            click(spot)
        }
        pass(200)
        return spot
    }

    private companion object {
        /** How many places of a block are touched. */
        const val SPOTS = 8

        const val SQUARE = "repeat 4 times\n  forward 20\n  turn left 90\nend\n"
        val LONG = (1..2_000).joinToString("\n", postfix = "\n") { "forward $it" }

        /** Below the middle of the last block. */
        val CLEAR = Offset(60f, -4f)
    }
}
