package robotran.ui.program.blocks

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.onAllNodesWithTag
import androidx.compose.ui.test.onNodeWithTag
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTouchInput
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.unit.LayoutDirection
import robotran.ui.program.keys
import robotran.ui.program.tags.ProgramTags
import robotran.ui.screen.pass
import robotran.ui.screen.touch
import robotran.workshop.blocks.BlockDialog
import robotran.workshop.event.BlockEvent
import robotran.workshop.text
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNull
import kotlin.test.assertTrue

/** Tests blocks with a keyboard and without a pointer. */
@OptIn(ExperimentalTestApi::class)
class BlocksKeyboardTest {
    @Test
    fun `arrows walk, Enter edits, and digits and Enter change the number`() =
        onTabletInBlocks("beep\nforward 20\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.DirectionDown, Key.DirectionRight, Key.DirectionRight, Key.Enter))
            keys(listOf(Key.Three, Key.Five))
            assertEquals("beep\nforward 35\n", workshop.text)
            keys(listOf(Key.Enter))
            keys(listOf(Key.DirectionUp))
            keys(listOf(Key.Delete))
            assertEquals("forward 35\n", workshop.text)
        }

    @Test
    fun `Alt and arrows move a block, Ctrl D doubles it, Ctrl Z takes back`() = onTabletInBlocks("beep\nbuzz\n") {
        focusBlocks()
        keys(listOf(Key.DirectionDown))
        keys(listOf(Key.DirectionDown), with = Key.AltLeft)
        assertEquals("buzz\nbeep\n", it.text)
        keys(listOf(Key.D), with = Key.CtrlLeft)
        assertEquals("buzz\nbeep\nbeep\n", it.text)
        keys(listOf(Key.Z), with = Key.CtrlLeft)
        assertEquals("buzz\nbeep\n", it.text)
    }

    @Test
    fun `Insert opens the palette at its search, arrows and Enter take a block, and the keyboard goes on there`() =
        onTabletInBlocks("beep\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.Insert))
            pass(300)
            onNodeWithTag(ProgramTags.PALETTE_SEARCH).assertIsFocused().performTextInput("buzz")
            pass(200)
            keys(listOf(Key.DirectionDown))
            keys(listOf(Key.Enter))
            pass(300)
            assertEquals("beep\nbuzz\n", workshop.text)
            assertTrue(onAllNodesWithTag(ProgramTags.BLOCK_SHEET).fetchSemanticsNodes().isEmpty())
            keys(listOf(Key.DirectionUp), with = Key.AltLeft)
            assertEquals("buzz\nbeep\n", workshop.text)
            keys(listOf(Key.Insert))
            pass(300)
            onNodeWithTag(ProgramTags.PALETTE_SEARCH).performTextInput("stop")
            pass(200)
            keys(listOf(Key.Enter))
            assertEquals("buzz\nstop\nbeep\n", workshop.text)
        }

    @Test
    fun `Escape closes each sheet and the keyboard is at the block again`() =
        onTabletInBlocks("turn left 90\nbeep\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown))
            for (open in listOf(Key.F2, Key.Insert, Key.Enter)) {
                keys(listOf(open))
                pass(300)
                assertEquals(1, onAllNodesWithTag(ProgramTags.BLOCK_SHEET).fetchSemanticsNodes().size)
                keys(listOf(Key.Escape))
                pass(300)
                assertTrue(onAllNodesWithTag(ProgramTags.BLOCK_SHEET).fetchSemanticsNodes().isEmpty())
            }
            keys(listOf(Key.DirectionDown))
            keys(listOf(Key.Delete))
            assertEquals("turn left 90\n", workshop.text)
        }

    @Test
    fun `the sheets of choices and of actions have the focus and are used with arrows and Enter`() =
        onTabletInBlocks("turn left 90\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.DirectionRight, Key.Enter))
            pass(300)
            keys(listOf(Key.DirectionRight))
            keys(listOf(Key.Enter))
            pass(300)
            assertEquals("turn right 90\n", workshop.text)
            keys(listOf(Key.F2))
            pass(300)
            // The first button duplicates the block.
            keys(listOf(Key.Enter))
            pass(300)
            assertEquals("turn right 90\nturn right 90\n", workshop.text)
        }

    @Test
    fun `a key that is held for a while opens a sheet and does not press what is in it when it is let go`() =
        onTabletInBlocks("turn left 90\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.DirectionRight))
            onNodeWithTag(ProgramTags.BLOCKS).performKeyInput { keyDown(Key.Enter) }
            pass(600)
            onNodeWithTag(ProgramTags.BLOCK_SHEET).performKeyInput { keyUp(Key.Enter) }
            pass(300)
            onNodeWithTag(ProgramTags.BLOCK_SHEET).assertExists()
            assertEquals("turn left 90\n", workshop.text)
        }

    @Test
    fun `Shift and arrows select blocks, Delete deletes them, and on a value puts another one there`() =
        onTabletInBlocks("beep\nbuzz\nstop\nforward light\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown))
            keys(listOf(Key.DirectionDown, Key.DirectionDown, Key.DirectionUp), with = Key.ShiftLeft)
            keys(listOf(Key.Delete))
            assertEquals("stop\nforward light\n", workshop.text)
            keys(listOf(Key.MoveEnd, Key.DirectionRight, Key.DirectionRight, Key.Delete))
            assertEquals("stop\nforward 20\n", workshop.text)
        }

    @Test
    fun `Alt and arrows to the sides lead a block out of another one and back`() =
        onTabletInBlocks("repeat 2 times\n  beep\nend\n") { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown, Key.DirectionDown))
            keys(listOf(Key.DirectionLeft), with = Key.AltLeft)
            assertEquals("repeat 2 times\nend\nbeep\n", workshop.text)
            keys(listOf(Key.DirectionRight), with = Key.AltLeft)
            assertEquals("repeat 2 times\n  beep\nend\n", workshop.text)
        }

    @Test
    fun `blocks are copied as Robolang, and any text is pasted as blocks`() = OwnClipboard().let { clipboard ->
        onTabletInBlocks("repeat 2 times\n  forward 20\nend\n", clipboard = clipboard) { workshop ->
            focusBlocks()
            keys(listOf(Key.DirectionDown))
            keys(listOf(Key.X), with = Key.CtrlLeft)
            assertEquals("", workshop.text.trim())
            assertEquals("repeat 2 times\n  forward 20\nend\n", clipboard.getText()?.text)
            keys(listOf(Key.V), with = Key.CtrlLeft)
            assertEquals("repeat 2 times\n  forward 20\nend", workshop.text.trim())
            clipboard.setText(AnnotatedString("dance, robot"))
            keys(listOf(Key.V), with = Key.CtrlLeft)
            assertEquals("repeat 2 times\n  dance, robot\n  forward 20\nend", workshop.text.trim())
        }
    }

    @Test
    fun `a note is written and put away with keys`() = onTabletInBlocks("beep\n") { workshop ->
        focusBlocks()
        keys(listOf(Key.DirectionDown))
        workshop.handle(BlockEvent.DialogShown(BlockDialog.Note(0)))
        pass(300)
        onNodeWithTag(ProgramTags.field(ProgramTags.NOTE)).assertIsFocused().performTextInput("loud")
        keys(listOf(Key.Enter))
        pass(300)
        assertEquals("beep  // loud\n", workshop.text)
        workshop.handle(BlockEvent.DialogShown(BlockDialog.Note(0)))
        pass(300)
        keys(listOf(Key.Escape))
        pass(300)
        assertTrue(onAllNodesWithTag(ProgramTags.BLOCK_SHEET).fetchSemanticsNodes().isEmpty())
        keys(listOf(Key.D), with = Key.CtrlLeft)
        assertEquals("beep  // loud\nbeep  // loud\n", workshop.text)
    }

    @Test
    fun `after a touch the keys go on at that block`() = onTabletInBlocks("beep\nbuzz\n") { workshop ->
        touch(ProgramTags.block("1"))
        keys(listOf(Key.Delete))
        assertEquals("beep\n", workshop.text)
    }

    @Test
    fun `Tab leaves the list`() = onTabletInBlocks("beep\nbuzz\n") { workshop ->
        focusBlocks()
        keys(listOf(Key.DirectionDown))
        keys(listOf(Key.Tab))
        keys(listOf(Key.Tab))
        keys(listOf(Key.Delete))
        assertEquals("beep\nbuzz\n", workshop.text)
    }

    @Test
    fun `from right to left the arrow to the left leads into a line`() = onTabletInBlocks(
        "forward 20\n",
        LayoutDirection.Rtl,
        OwnClipboard(),
    ) { workshop ->
        focusBlocks()
        keys(listOf(Key.DirectionDown, Key.DirectionLeft, Key.DirectionLeft))
        assertEquals("20", workshop.state.programs.blocks?.part?.textIn(workshop.text))
        keys(listOf(Key.DirectionRight, Key.DirectionRight))
        assertNull(workshop.state.programs.blocks?.part)
    }

    @Test
    fun `from right to left a finger carries blocks and values`() = onTabletInBlocks(
        "beep\nforward light\nturn left 90\n",
        LayoutDirection.Rtl,
        OwnClipboard(),
    ) { workshop ->
        carry(socketOf(workshop.text, "light"), placeOf(socketOf(workshop.text, "90")).center)
        assertEquals("beep\nforward 20\nturn left light\n", workshop.text)
        // The grip is at the right end; there a finger need not rest.
        val grip = placeOf(ProgramTags.block("0")).centerRight - Offset(10f, 0f)
        val list = placeOf(ProgramTags.BLOCKS).topLeft
        onNodeWithTag(ProgramTags.BLOCKS).performTouchInput {
            down(grip - list)
            moveBy(Offset(0f, 40f))
            moveTo(placeOf(ProgramTags.block("2")).bottomRight - list + Offset(-60f, -4f))
            up()
        }
        pass(200)
        assertEquals("forward 20\nturn left light\nbeep\n", workshop.text)
    }
}
